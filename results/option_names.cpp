// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/option_names.h"

#include <algorithm>

#include "isomatch/error.h"

namespace isomatch::results {

std::string option_name(std::string_view field) {
  if (field == "max_levels") return "levels";
  std::string name(field);
  std::ranges::replace(name, '_', '-');
  return name;
}

GeodesicOptions geodesic_options(const std::string& name) {
  if (name == "edges") return GeodesicOptions::edges();
  if (name == "w10") return GeodesicOptions::w10();
  if (name == "w20") return GeodesicOptions::w20();
  throw InvalidInput("geodesics: expected w20, w10 or edges, not " + name);
}

}  // namespace isomatch::results
