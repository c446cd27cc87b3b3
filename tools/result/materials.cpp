// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "result/materials.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <sstream>

#include "isomatch/error.h"
#include "isomatch/texture_io.h"

namespace isomatch::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlanks = " \t\r";

/// Keywords of lines that end with the name of an image.
bool names_image(const std::string& keyword) {
  return keyword.starts_with("map_") || keyword == "bump" || keyword == "disp" ||
         keyword == "decal" || keyword == "refl" || keyword == "norm";
}

std::string first_word(const std::string& line) {
  std::string word;
  std::istringstream(line) >> word;
  return word;
}

std::string without_end_blanks(const std::string& text) {
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

void read_images(const fs::path& library, std::map<std::string, std::string>& images) {
  std::ifstream file(library);
  std::string material;
  for (std::string line; std::getline(file, line);) {
    const std::string keyword = first_word(line);
    if (keyword == "newmtl") {
      const std::size_t start = line.find_first_not_of(kBlanks, line.find(keyword) + 6);
      material = start == std::string::npos ? "" : without_end_blanks(line.substr(start));
    } else if (keyword == "map_Kd") {
      if (const auto start = image_name_start(line, library.parent_path()))
        images[material] =
            (library.parent_path() / without_end_blanks(line.substr(*start))).string();
    }
  }
}

}  // namespace

std::optional<std::size_t> image_name_start(const std::string& line, const fs::path& folder) {
  const std::string keyword = first_word(line);
  if (!names_image(keyword)) return std::nullopt;
  const std::string text = without_end_blanks(line);
  std::size_t at = text.find_first_not_of(kBlanks, text.find(keyword) + keyword.size());
  while (at != std::string::npos) {
    const std::size_t blank = text.find_first_of(kBlanks, at);
    if (blank == std::string::npos || fs::exists(folder / text.substr(at))) return at;
    at = text.find_first_not_of(kBlanks, blank);
  }
  return std::nullopt;
}

std::vector<std::string> material_images(const std::string& path,
                                         const std::vector<std::string>& materials) {
  std::map<std::string, std::string> images;
  for (const std::string& name : material_libraries(path)) {
    const fs::path library = fs::path(path).parent_path() / name;
    if (!fs::exists(library))
      throw BadFile(library.string(), fmt::format("cannot be opened; {} names it", path));
    read_images(library, images);
  }
  std::vector<std::string> result;
  for (const std::string& material : materials) result.push_back(images[material]);
  return result;
}

}  // namespace isomatch::cli
