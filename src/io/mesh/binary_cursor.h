// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

#include "io/byte_order.h"
#include "io/input_file.h"

namespace isomatch::mesh_io {

/// Walks through a file of binary values in byte order `kByteOrder`. Failures are `BadFile` and
/// name the byte where the last value begins. No value is read beyond the end of the file.
template <std::endian kByteOrder>
class BinaryCursor {
 public:
  /// Begins at `position` in `file`, to which it keeps a reference.
  BinaryCursor(const InputFile& file, const char* position)
      : file_(&file), value_(position), next_(position) {}

  /// The next value, a number of type T.
  template <class T>
  T take() {
    skip(sizeof(T));
    return load<T>(value_, kByteOrder);
  }

  /// Passes over the next `count` values of `size` bytes each.
  void skip(std::int64_t size, std::int64_t count = 1) {
    value_ = next_;
    if (count > remaining() / size) fail("the file ends too early");
    next_ += size * count;
  }

  /// Bytes from here to the end of the file.
  std::int64_t remaining() const { return file_->end() - next_; }

  /// Fails unless the file ends here.
  void expect_end() {
    value_ = next_;
    if (remaining() > 0) fail("more bytes follow than the file announces");
  }

  [[noreturn]] void fail(const std::string& reason) const { file_->fail_at_byte(value_, reason); }

 private:
  const InputFile* file_;
  const char* value_;
  const char* next_;
};

}  // namespace isomatch::mesh_io
