// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

namespace isomatch::results {

/// The files that a command reads, none of which it may write to. Files are compared by what they
/// are, whatever names and links lead to them.
class InputFiles {
 public:
  InputFiles() = default;
  /// `add` for each.
  explicit InputFiles(const std::vector<std::string>& paths);

  /// Adds a file, and of an .obj file the materials and images that it names, as far as they can be
  /// read. An empty name is none.
  void add(const std::string& path);

  bool contains(const std::string& path) const;
  /// Throws `BadFile` if `output` is one of the files.
  void refuse(const std::string& output) const;

 private:
  void add_materials(const std::string& path);

  std::vector<std::string> paths_;
};

}  // namespace isomatch::results
