// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/files/input_files.h"

#include <filesystem>
#include <utility>

#include "isomatch/error.h"
#include "isomatch/io/material_libraries.h"
#include "results/files/image_line.h"
#include "results/files/outputs.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

bool has_materials(const std::string& path) { return lower_ending(path) == ".obj"; }

/// The images that a file of materials names, as far as they are there.
std::vector<std::string> images_of(const std::string& library) {
  std::vector<std::string> images;
  for (const std::string& line : material_lines(library)) {
    const auto image = image_line(line, library);
    if (image && !image->path.empty()) images.push_back(image->path);
  }
  return images;
}

}  // namespace

InputFiles::InputFiles(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) add(path);
}

void InputFiles::add(const std::string& path) {
  if (path.empty()) return;
  paths_.push_back(path);
  if (has_materials(path)) add_materials(path);
}

void InputFiles::add_materials(const std::string& path) {
  try {
    for (const std::string& name : material_libraries(path)) {
      const std::string library = find_named_file(name, path);
      if (library.empty()) continue;
      paths_.push_back(library);
      for (std::string& image : images_of(library)) paths_.push_back(std::move(image));
    }
  } catch (const BadFile&) {
    // Whoever needs the file says what is wrong with it.
    return;
  }
}

bool InputFiles::contains(const std::string& path) const {
  for (const std::string& input : paths_) {
    std::error_code error;
    if (fs::equivalent(input, path, error)) return true;
  }
  return false;
}

void InputFiles::refuse(const std::string& output) const {
  if (contains(output))
    throw BadFile(output, "is read here, and would be overwritten; choose another output");
}

}  // namespace isomatch::results
