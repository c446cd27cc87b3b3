// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

namespace isomatch::results {

/// The files in a folder that are meshes by their endings, hidden ones aside, by their names.
/// Throws `BadFile` if it cannot be read.
std::vector<std::string> meshes_in(const std::string& folder);

}  // namespace isomatch::results
