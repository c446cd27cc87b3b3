// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "results/warn.h"

/// Files of materials (.mtl), as far as images go. What is not there is a warning.
namespace isomatch::results {

struct MaterialLibrary {
  /// As the .obj file names it.
  std::string name;
  /// Empty if it is not there.
  std::string path;
  /// Without line ends.
  std::vector<std::string> lines;
};

/// The files of materials that the .obj file `path` names.
std::vector<MaterialLibrary> load_libraries(const std::string& path, const Warn& warn);

/// Warns of what `path` names though it is not there, unless `names` is empty.
void warn_of_missing(const std::string& path, std::string_view what,
                     const std::set<std::string>& names, const Warn& warn);
/// The same of images that a file of materials names.
void warn_of_images(const MaterialLibrary& library, const std::set<std::string>& missing,
                    const Warn& warn);
/// The same of the materials of the .obj file `path` that are none of `known`, which `libraries`
/// have, if all of these are there and any has materials.
void warn_of_materials(const std::string& path, const std::vector<std::string>& materials,
                       const std::set<std::string>& known,
                       const std::vector<MaterialLibrary>& libraries, const Warn& warn);

/// For each of `materials` the image of its colour (`map_Kd`), empty where it has none. The files
/// are those that the .obj file `path` names; the first one that has a material counts.
std::vector<std::string> material_images(const std::string& path,
                                         const std::vector<std::string>& materials,
                                         const Warn& warn);

}  // namespace isomatch::results
