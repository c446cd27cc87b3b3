// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/group/collection.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "isomatch/error.h"
#include "isomatch/io/mesh_io.h"
#include "results/files/mesh_files.h"
#include "results/files/written_files.h"
#include "results/group/group_output.h"
#include "results/loaded_mesh.h"

namespace isomatch::results {
namespace {

/// The meshes in a folder but for those that isomatch left there.
std::vector<std::string> foreign_meshes(const std::string& folder) {
  const std::vector<std::string> written = written_files(folder, Listing::kOfMatch);
  std::vector<std::string> meshes = meshes_in(folder);
  std::erase_if(meshes, [&](const std::string& path) {
    return std::ranges::binary_search(written, std::filesystem::path(path).filename().string());
  });
  return meshes;
}

}  // namespace

std::string shape_name(const std::string& path) {
  return std::filesystem::path(path).stem().string();
}

std::vector<std::string> collected_files(const std::vector<std::string>& places) {
  std::vector<std::string> files, names;
  for (const std::string& place : places) {
    std::error_code error;
    if (std::filesystem::is_directory(place, error)) {
      const std::vector<std::string> meshes = foreign_meshes(place);
      if (meshes.empty()) throw BadFile(place, "none of its files is a mesh");
      files.insert(files.end(), meshes.begin(), meshes.end());
    } else if (std::filesystem::exists(place, error)) {
      files.push_back(place);
    } else {
      throw BadFile(place, "is not there");
    }
  }
  for (const std::string& file : files) names.push_back(shape_name(file));
  check_shape_names(names);
  return files;
}

Collection read_collection(const std::vector<std::string>& files, const Warn& warn,
                           const Context& context) {
  Collection collection;
  for (const std::string& file : files) {
    context.check_stop();
    try {
      MeshReadReport report;
      Mesh mesh = read_mesh(file, &report);
      for (const std::string& warning : report.warnings) warn(file, warning);
      collection.shapes.push_back(shape_of(file, std::move(mesh)));
      collection.paths.push_back(file);
      collection.names.push_back(shape_name(file));
    } catch (const BadFile& error) {
      collection.left_out.push_back({file, error.what()});
    }
  }
  return collection;
}

}  // namespace isomatch::results
