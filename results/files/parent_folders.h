// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isomatch::results {

/// The folders above an output, made where they are missing. The destructor removes those of them
/// that are still empty, as they are if nothing was written. Make one before what checks the
/// output.
class ParentFolders {
 public:
  /// Throws `BadFile` if a folder cannot be made.
  explicit ParentFolders(const std::string& output);
  ~ParentFolders();
  ParentFolders(const ParentFolders&) = delete;
  ParentFolders& operator=(const ParentFolders&) = delete;

 private:
  void remove_empty();

  /// Outermost first.
  std::vector<std::filesystem::path> made_;
};

}  // namespace isomatch::results
