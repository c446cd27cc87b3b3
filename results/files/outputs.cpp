// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/files/outputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/io/mesh_io.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// Creates the folder and removes it again.
void try_to_create(const std::string& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (error) throw BadFile(folder, "cannot be created: " + error.message());
  fs::remove(folder, error);
}

}  // namespace

bool is_taken(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

std::string lower_ending(const std::string& path) {
  return lower_case(fs::path(path).extension().string());
}

void check_folder_name(const std::string& folder) {
  constexpr std::array kFiles{".csv", ".html", ".jpeg", ".jpg", ".json",
                              ".map", ".npz",  ".png",  ".txt", ".vts"};
  std::error_code error;
  const bool is_file_name =
      is_mesh_file_name(folder) || std::ranges::count(kFiles, lower_ending(folder)) > 0;
  if (is_file_name && !fs::is_directory(folder, error))
    throw BadFile(folder, "is named like a file, but a folder is written here");
}

void check_ending(const std::string& path, const std::vector<std::string>& endings) {
  if (std::ranges::count(endings, lower_ending(path)) == 0)
    throw BadFile(path, fmt::format("must be named {} here", fmt::join(endings, " or ")));
}

void check_output(const std::string& output, const InputFiles& inputs) {
  inputs.refuse(output);
  const AtomicFile attempt(output);
}

void check_companion_output(const std::string& output, const std::string& main,
                            const InputFiles& inputs) {
  check_output(output, inputs);
  if (is_taken(output) && !is_taken(main))
    throw BadFile(output, "is there already, but " + main +
                              ", beside which it goes, is not; choose another output or move it "
                              "away");
}

void check_folder_output(const std::string& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return try_to_create(folder);
  if (!fs::is_directory(status)) throw BadFile(folder, "is not a folder");
  // The name of the attempt does not matter: what is created is a temporary file.
  const AtomicFile attempt((fs::path(folder) / "report.json").string());
}

}  // namespace isomatch::results
