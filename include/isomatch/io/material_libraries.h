// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

namespace isomatch {

/// The files of materials that an .obj file names, as it names them, each once. A `mtllib` line may
/// name several files, and a name may hold blanks: the line is one name if that file is there,
/// otherwise it is the files that are there, the longest names first; what is left is split behind
/// words that end in ".mtl", and dropped from a # on.
std::vector<std::string> material_libraries(const std::string& path);

/// The path of the file that the mesh or material file `beside` calls `name`, seen from its folder:
/// as it is, without quotes around it, or with backslashes that stand before blanks or for slashes.
/// Empty if there is no such file.
std::string find_named_file(const std::string& name, const std::string& beside);

}  // namespace isomatch
