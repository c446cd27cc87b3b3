// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/hilbert.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "geometry/runs.h"

namespace isomatch {
namespace {

constexpr int kBits = 21;  // three coordinates fit one 64-bit key

using Cell = std::array<std::uint32_t, 3>;

/// Turns the coordinates of a cell into its place on the curve, bit-transposed: Skilling,
/// "Programming the Hilbert curve", AIP Conference Proceedings 707, 2004.
Cell transposed_place(Cell cell) {
  // Written without branches, of which half would be mispredicted.
  for (int i = kBits - 1; i > 0; --i) {
    const std::uint32_t lower_bits = (1u << i) - 1;
    for (std::uint32_t& x : cell) {
      const std::uint32_t invert = -(x >> i & 1) & lower_bits;
      const std::uint32_t exchange = (cell[0] ^ x) & (lower_bits ^ invert);
      cell[0] ^= invert | exchange;
      x ^= exchange;
    }
  }
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t flips = 0;
  for (int i = kBits - 1; i > 0; --i) flips ^= -(cell[2] >> i & 1) & ((1u << i) - 1);
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

std::vector<std::pair<std::uint64_t, int>> curve_keys(std::span<const Point> points) {
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
  return keys;
}

void sort_by_coordinates(std::span<const Point> points, std::span<int> order) {
  std::ranges::stable_sort(order, [&](int a, int b) {
    return std::ranges::lexicographical_compare(points[a], points[b]);
  });
}

}  // namespace

std::vector<int> hilbert_order(std::span<const Point> points) {
  if (points.empty()) return {};
  std::vector<std::pair<std::uint64_t, int>> keys = curve_keys(points);
  std::ranges::sort(keys);
  std::vector<int> order(points.size());
  std::ranges::transform(keys, order.begin(), [](const auto& key) { return key.second; });
  const auto same_cell = [&](int a, int b) { return keys[a].first == keys[b].first; };
  for_each_run(static_cast<int>(keys.size()), same_cell, [&](int first, int last) {
    if (last - first > 1)
      sort_by_coordinates(points, std::span(order).subspan(first, last - first));
  });
  return order;
}

}  // namespace isomatch
