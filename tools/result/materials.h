// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Files of materials (.mtl), as far as images go.
namespace isomatch::cli {

/// Where in a line of a file in `folder` the name of an image begins, if it names one. Options may
/// stand before the name, and the name may hold blanks: the longest rest of the line that is a file
/// counts, failing that the last word.
std::optional<std::size_t> image_name_start(const std::string& line,
                                            const std::filesystem::path& folder);

/// For each of `materials` the image of its colour (`map_Kd`), empty where it has none. The files
/// are those that the .obj file `path` names. Throws `BadFile` if one is not there.
std::vector<std::string> material_images(const std::string& path,
                                         const std::vector<std::string>& materials);

}  // namespace isomatch::cli
