// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "isomatch/io/atomic_file.h"

namespace isomatch {

/// Writes a text file line by line.
class LineWriter {
 public:
  /// Keeps a reference to `file`, which is the caller's to commit.
  explicit LineWriter(AtomicFile& file) : file_(file) {}

  /// Appends a line; its end is added.
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    line_.clear();
    fmt::format_to(std::back_inserter(line_), format, std::forward<Arguments>(arguments)...);
    line_.push_back('\n');
    file_.write({line_.data(), line_.size()});
  }

 private:
  AtomicFile& file_;
  fmt::memory_buffer line_;
};

}  // namespace isomatch
