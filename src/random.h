// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace isomatch {

/// A small generator (SplitMix64) with distributions that give the same numbers everywhere, which
/// those of the standard library do not promise.
class Random {
 public:
  /// Different lists of keys give independent streams.
  Random(std::initializer_list<std::uint64_t> keys) {
    for (std::uint64_t key : keys) {
      state_ ^= key;
      state_ = next();
    }
  }

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// In [low, high).
  double uniform(double low = 0, double high = 1) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
  }

  /// In [0, bound); `bound` is at least 1. The bias is below bound / 2^64.
  int below(int bound) { return static_cast<int>(next() % static_cast<std::uint64_t>(bound)); }

  template <class T>
  void shuffle(std::vector<T>& values) {
    for (std::size_t i = values.size(); i > 1; --i)
      std::swap(values[i - 1], values[below(static_cast<int>(i))]);
  }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace isomatch
