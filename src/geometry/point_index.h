// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// Numbers distinct points in the order of their first appearance. -0 equals 0. A hash table with
/// linear probing, at most half full; it holds the points' numbers.
class PointIndex {
 public:
  /// The number of `point`, a new one if it has not appeared before.
  int number_of(const Point& point) {
    if (2 * points_.size() >= slots_.size()) grow();
    int& slot = slots_[find_slot(point)];
    if (slot == kFree) {
      slot = static_cast<int>(points_.size());
      points_.push_back(point);
    }
    return slot;
  }

  /// All distinct points by their numbers; leaves this empty.
  std::vector<Point> take_points() { return std::move(points_); }

 private:
  static constexpr int kFree = -1;
  static constexpr std::size_t kLeastSlots = 64;

  /// Equal where coordinates are, and also of what is not a number, so that it is found again.
  static std::uint64_t bits(double coordinate) {
    // Adding 0 turns -0 into 0.
    return std::bit_cast<std::uint64_t>(coordinate + 0.0);
  }

  static bool is_same(const Point& a, const Point& b) {
    return std::ranges::equal(a, b, {}, bits, bits);
  }

  static std::uint64_t hash(const Point& point) {
    std::uint64_t result = 0;
    for (const double coordinate : point) {
      result = (result ^ bits(coordinate)) * 0x9e3779b97f4a7c15u;
      result ^= result >> 32;
    }
    return result;
  }

  /// The slot that holds `point`, or the free one where it belongs. The number of slots is a power
  /// of two.
  std::size_t find_slot(const Point& point) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash(point) & mask;
    while (slots_[at] != kFree && !is_same(points_[slots_[at]], point)) at = (at + 1) & mask;
    return at;
  }

  void grow() {
    slots_.assign(slots_.empty() ? kLeastSlots : 2 * slots_.size(), kFree);
    for (std::size_t i = 0; i < points_.size(); ++i)
      slots_[find_slot(points_[i])] = static_cast<int>(i);
  }

  std::vector<Point> points_;
  std::vector<int> slots_;
};

}  // namespace isomatch
