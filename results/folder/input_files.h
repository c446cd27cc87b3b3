// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isomatch::cli {

/// Whether something has this name, be it a link that leads nowhere.
bool is_taken(const std::filesystem::path& path);

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

/// The ending of `path`, with its dot and without capitals.
std::string lower_ending(const std::string& path);

/// Throws `BadFile` if `folder` is named like a file, and is not there yet.
void check_folder_name(const std::string& folder);

/// Throws `BadFile` unless `path` ends with one of `endings`, in capitals or not.
void check_ending(const std::string& path, const std::vector<std::string>& endings);

/// Throws `BadFile` if the file `output` is one of `inputs` or cannot be written. Leaves no trace.
void check_output(const std::string& output, const InputFiles& inputs);

/// The same for a file whose name the user did not give, only that of `main`, beside which it goes.
/// It is only replaced along with `main`.
void check_companion_output(const std::string& output, const std::string& main,
                            const InputFiles& inputs);

/// Throws `BadFile` unless `folder` is a folder in which files can be created, or can be created
/// itself, in a folder that is there. Leaves no trace.
void check_folder_output(const std::string& folder);

}  // namespace isomatch::cli
