// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/template.h"

namespace isomatch::results {

std::string_view page_template() { return {}; }

}  // namespace isomatch::results
