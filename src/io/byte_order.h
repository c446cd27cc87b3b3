// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace isomatch {

/// The number of type T that stands at `bytes`, aligned or not, in byte order `order`.
template <class T>
T load(const char* bytes, std::endian order = std::endian::little) {
  std::array<char, sizeof(T)> part;
  std::memcpy(part.data(), bytes, sizeof(T));
  if (order != std::endian::native) std::reverse(part.begin(), part.end());
  return std::bit_cast<T>(part);
}

/// Appends `value`, lowest byte first, to a string or vector of bytes.
template <class T, class Bytes>
void append_little_endian(T value, Bytes& bytes) {
  auto part = std::bit_cast<std::array<typename Bytes::value_type, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(part.begin(), part.end());
  bytes.insert(bytes.end(), part.begin(), part.end());
}

}  // namespace isomatch
