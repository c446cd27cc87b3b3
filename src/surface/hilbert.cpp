// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "surface/hilbert.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace isomatch {
namespace {

constexpr int kBits = 21;  // three coordinates fit one 64-bit key

using Cell = std::array<std::uint32_t, 3>;

/// Turns the coordinates of a cell into its place on the curve, bit-transposed: Skilling,
/// "Programming the Hilbert curve", AIP Conference Proceedings 707, 2004.
Cell transposed_place(Cell cell) {
  for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1) {
    for (std::uint32_t& x : cell) {
      const std::uint32_t swapped = (cell[0] ^ x) & (bit - 1);
      if (x & bit) {
        cell[0] ^= bit - 1;
      } else {
        cell[0] ^= swapped;
        x ^= swapped;
      }
    }
  }
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t flips = 0;
  for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1) {
    if (cell[2] & bit) flips ^= bit - 1;
  }
  for (std::uint32_t& x : cell) x ^= flips;
  return cell;
}

/// Moves bit i to bit 3 i.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

std::uint64_t curve_key(const Cell& cell) {
  const Cell place = transposed_place(cell);
  return spread(place[0]) << 2 | spread(place[1]) << 1 | spread(place[2]);
}

}  // namespace

std::vector<int> hilbert_order(std::span<const Point> points) {
  if (points.empty()) return {};
  Eigen::Array3d low = points[0], high = points[0];
  for (const Point& p : points) {
    low = low.min(p.array());
    high = high.max(p.array());
  }
  const double side = (high - low).maxCoeff();
  const double cells_per_unit = side > 0 ? ((1u << kBits) - 1) / side : 0;
  std::vector<std::pair<std::uint64_t, int>> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Array3d place = (points[i].array() - low) * cells_per_unit;
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) cell[axis] = static_cast<std::uint32_t>(place[axis]);
    keys[i] = {curve_key(cell), static_cast<int>(i)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order(points.size());
  std::ranges::transform(keys, order.begin(), [](const auto& key) { return key.second; });
  return order;
}

}  // namespace isomatch
