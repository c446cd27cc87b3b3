// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>

#include "isomatch/io/atomic_file.h"

namespace isomatch {

/// A text file that is written line by line, and appears as `AtomicFile` does.
class LineFile {
 public:
  explicit LineFile(const std::string& path) : file_(path) {}

  /// Appends a line; its end is added.
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    line_.clear();
    fmt::format_to(std::back_inserter(line_), format, std::forward<Arguments>(arguments)...);
    line_.push_back('\n');
    file_.write({line_.data(), line_.size()});
  }

  void commit() { file_.commit(); }

 private:
  AtomicFile file_;
  fmt::memory_buffer line_;
};

}  // namespace isomatch
