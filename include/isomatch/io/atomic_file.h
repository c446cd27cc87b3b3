// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace isomatch {

/// An output file that appears whole or not at all. What is written goes to a hidden temporary file
/// in the same folder, which `commit` moves to `path`; a file that stood there before is replaced
/// then and not earlier. Destroyed without a commit, for example by an exception, it leaves no
/// trace.
///
/// A symbolic link is followed: the file that it points to is replaced. Guards against failures and
/// interruption of this program, not against loss of power.
class AtomicFile {
 public:
  /// Creates the temporary file. Throws `BadFile` if the folder does not exist or cannot be
  /// written, or if `path` is something else than a regular file, such as a folder or a device.
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends `bytes`; buffered. Throws `BadFile` if that fails, for example because the disk is
  /// full.
  void write(std::string_view bytes);

  /// Moves the finished file to `path`. Call it once, at the end; nothing can be written after it.
  /// Throws `BadFile` if the content cannot be stored or the file not be moved.
  void commit();

  const std::string& path() const { return path_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::string path_;
  std::filesystem::path destination_;
  std::filesystem::path temporary_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace isomatch
