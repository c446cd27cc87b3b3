// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isomatch::test {

/// A new empty folder that is removed with all its content in the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// The path of `name` in the folder.
  std::string path(std::string_view name) const { return (folder_ / name).string(); }
  /// Writes `content` to a file and returns its path.
  std::string write(std::string_view name, std::string_view content) const;
  /// The names of all that is in the folder, hidden files included, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path folder_;
};

/// All of a file. Fails the current test if it cannot be read.
std::string read_file(const std::string& path);

}  // namespace isomatch::test
