// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace isomatch {

/// The whole content of a file in memory, and the means to complain about a place in it.
class InputFile {
 public:
  /// Reads all of `path`. Throws `BadFile` if it is missing, a folder or otherwise not a regular
  /// file, not readable, or empty.
  explicit InputFile(std::string path);

  const std::string& path() const { return path_; }
  std::string_view content() const { return {content_.get(), size_}; }
  const char* begin() const { return content_.get(); }
  const char* end() const { return content_.get() + size_; }

  /// These throw `BadFile`. `place` points into the content; the line (from 1) or the byte (from 0)
  /// goes into the message. A line costs a pass over the content before it.
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void fail_at_line(const char* place, const std::string& reason) const;
  [[noreturn]] void fail_at_byte(const char* place, const std::string& reason) const;

 private:
  std::string path_;
  std::size_t size_ = 0;
  std::unique_ptr<char[]> content_;
};

/// `text` in quotes for an error message: shortened, and on one line whatever it contains.
std::string in_quotes(std::string_view text);

}  // namespace isomatch
