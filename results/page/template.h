// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string_view>

namespace isomatch::results {

/// The page without data, as viewer/ was bundled when this program was built; empty if it was built
/// without.
std::string_view page_template();

}  // namespace isomatch::results
