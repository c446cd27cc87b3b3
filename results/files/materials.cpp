// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/files/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "isomatch/io/material_libraries.h"
#include "results/files/image_line.h"

namespace isomatch::results {
namespace {

/// Of images that are not there.
constexpr std::size_t kMostNames = 3;

using Images = std::map<std::string, std::string>;

Images images_of(const MaterialLibrary& library, const Warn& warn) {
  Images images;
  std::set<std::string> missing;
  std::string material;
  for (const std::string& line : library.lines) {
    if (const auto name = new_material(line)) {
      images.try_emplace(material = *name);
    } else if (keyword_of(line) == "map_Kd") {
      const auto image = image_line(line, library.path);
      if (!image) continue;
      if (image->path.empty()) missing.insert(image->name);
      images[material] = image->path;
    }
  }
  warn_of_images(library, missing, warn);
  return images;
}

}  // namespace

std::vector<MaterialLibrary> load_libraries(const std::string& path, const Warn& warn) {
  std::vector<MaterialLibrary> libraries;
  std::set<std::string> missing;
  for (const std::string& name : material_libraries(path)) {
    MaterialLibrary& library = libraries.emplace_back(name, find_named_file(name, path));
    if (library.path.empty())
      missing.insert(name);
    else
      library.lines = material_lines(library.path);
  }
  warn_of_missing(path, "files of materials that are not there", missing, warn);
  return libraries;
}

void warn_of_missing(const std::string& path, std::string_view what,
                     const std::set<std::string>& names, const Warn& warn) {
  if (names.empty()) return;
  std::string list;
  std::size_t left = kMostNames;
  for (auto name = names.begin(); name != names.end() && left > 0; ++name, --left)
    list += (list.empty() ? "" : ", ") + *name;
  if (names.size() > kMostNames) list += fmt::format(", and {} more", names.size() - kMostNames);
  warn(path, fmt::format("{}: {}", what, list));
}

void warn_of_images(const MaterialLibrary& library, const std::set<std::string>& missing,
                    const Warn& warn) {
  warn_of_missing(library.path, "images that are not there", missing, warn);
}

void warn_of_materials(const std::string& path, const std::vector<std::string>& materials,
                       const std::set<std::string>& known,
                       const std::vector<MaterialLibrary>& libraries, const Warn& warn) {
  const auto is_there = [](const MaterialLibrary& library) { return !library.path.empty(); };
  if (!std::ranges::all_of(libraries, is_there)) return;
  // What is made of a mesh without materials has "none" alone.
  if (known.size() == known.count("none")) return;
  std::set<std::string> missing;
  for (const std::string& material : materials)
    if (!known.contains(material)) missing.insert(material);
  warn_of_missing(path, "materials that are in none of its files", missing, warn);
}

std::vector<std::string> material_images(const std::string& path,
                                         const std::vector<std::string>& materials,
                                         const Warn& warn) {
  const std::vector<MaterialLibrary> libraries = load_libraries(path, warn);
  Images images;
  for (const MaterialLibrary& library : libraries) images.merge(images_of(library, warn));
  std::set<std::string> known;
  for (const auto& [material, image] : images) known.insert(material);
  warn_of_materials(path, materials, known, libraries, warn);
  std::vector<std::string> result;
  for (const std::string& material : materials) result.push_back(images[material]);
  return result;
}

}  // namespace isomatch::results
