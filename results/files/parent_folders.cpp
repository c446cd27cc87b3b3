// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/files/parent_folders.h"

#include <algorithm>
#include <ranges>

#include "isomatch/error.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

/// Outermost first.
std::vector<fs::path> missing_folders(fs::path folder) {
  std::error_code error;
  std::vector<fs::path> missing;
  for (; !folder.empty() && !fs::exists(folder, error); folder = folder.parent_path())
    missing.push_back(folder);
  std::ranges::reverse(missing);
  return missing;
}

}  // namespace

ParentFolders::ParentFolders(const std::string& output) {
  for (const fs::path& folder : missing_folders(fs::path(output).parent_path())) {
    std::error_code error;
    if (fs::create_directory(folder, error)) made_.push_back(folder);
    if (!error) continue;
    remove_empty();
    throw BadFile(output, "cannot be created: " + folder.string() + ": " + error.message());
  }
}

ParentFolders::~ParentFolders() { remove_empty(); }

void ParentFolders::remove_empty() {
  std::error_code ignored;
  for (const fs::path& folder : made_ | std::views::reverse) fs::remove(folder, ignored);
}

}  // namespace isomatch::results
