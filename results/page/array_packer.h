// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "results/json.h"

namespace isomatch::results {

/// Packs arrays of unsigned integers into one compressed block of text, for a page that unpacks
/// them again (viewer/src/data/arrays.ts).
class ArrayPacker {
 public:
  /// `kDelta` stores differences of neighbours, which compress better where values vary slowly.
  enum class Layout { kPlain, kDelta };

  /// Appends an array under a name that is used once. Values must fit into `bytes` (1, 2 or 4).
  void add(const std::string& name, std::span<const std::uint32_t> values, int bytes,
           Layout layout = Layout::kPlain);

  /// For each array in order its name, count, bytes and layout.
  const Json& directory() const { return directory_; }

  /// All arrays, compressed (zlib format) and in base64. Each array is stored as its values' lowest
  /// bytes, then their second ones and so on, so that the empty upper bytes vanish.
  std::string pack() const;

 private:
  Json directory_ = Json::array();
  std::string bytes_;
};

/// Interleaves negative and positive numbers, 0 -1 1 -2 2 ..., so that small ones stay small.
std::uint32_t zigzag(std::int32_t value);

/// `bytes` as text of 64 letters (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace isomatch::results
