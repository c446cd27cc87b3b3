// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <zlib.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace isomatch {

/// Undoes zlib's compression, piece by piece.
class Inflater {
 public:
  /// `data` must outlive this and be smaller than 4 GiB.
  explicit Inflater(std::string_view data);
  ~Inflater();
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// The next `size` bytes; fewer where the data ends or is damaged. Memory follows what is there,
  /// not `size`.
  std::string take(std::size_t size);

 private:
  z_stream stream_{};
};

}  // namespace isomatch
