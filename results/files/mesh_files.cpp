// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/files/mesh_files.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "isomatch/error.h"
#include "results/files/outputs.h"

namespace isomatch::results {

namespace fs = std::filesystem;

std::vector<std::string> meshes_in(const std::string& folder) {
  constexpr std::array kEndings{".off", ".obj", ".ply", ".stl", ".glb", ".gltf", ".mat"};
  const auto is_mesh = [&](const fs::directory_entry& entry) {
    std::error_code error;
    return entry.is_regular_file(error) && !entry.path().filename().string().starts_with('.') &&
           std::ranges::count(kEndings, lower_ending(entry.path().string())) > 0;
  };
  std::error_code error;
  std::vector<std::string> meshes;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    if (is_mesh(*entry)) meshes.push_back(entry->path().string());
  if (error) throw BadFile(folder, error.message());
  std::ranges::sort(meshes);
  return meshes;
}

}  // namespace isomatch::results
