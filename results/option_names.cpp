// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/option_names.h"

#include <algorithm>

namespace isomatch::results {

std::string option_name(std::string_view field) {
  if (field == "max_levels") return "levels";
  std::string name(field);
  std::ranges::replace(name, '_', '-');
  return name;
}

}  // namespace isomatch::results
