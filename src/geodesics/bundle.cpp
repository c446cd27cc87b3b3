// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geodesics/bundle.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "wide_vectors.h"

namespace isomatch {
namespace {

using Distances = FieldBundle::Distances;

/// Distances that a processor handles at once. Compilers do not see by themselves that they may.
using Vector = float __attribute__((vector_size(32)));
using Bits = std::int64_t __attribute__((vector_size(32)));
constexpr int kVectors = sizeof(Distances) / sizeof(Vector);

/// Shortens the distances of each arc's head by the way over its tail; marks heads for which that
/// did something.
ISOMATCH_WIDE_VECTORS void relax(const Distances& tail, std::span<const GeodesicArc> arcs,
                                 Distances* distances, char* shortened) {
  const auto* const before = reinterpret_cast<const Vector*>(&tail);
  for (const GeodesicArc& arc : arcs) {
    auto* const head = reinterpret_cast<Vector*>(distances + arc.head);
    const float length = arc.length;
    Bits shorter{};
    for (int i = 0; i < kVectors; ++i) {
      const Vector over_tail = before[i] + length;
      const auto less = over_tail < head[i];
      shorter |= reinterpret_cast<Bits>(less);
      head[i] = less ? over_tail : head[i];
    }
    // Not a branch, which could not be predicted.
    shortened[arc.head] = static_cast<char>(
        shortened[arc.head] | ((shorter[0] | shorter[1] | shorter[2] | shorter[3]) != 0));
  }
}

}  // namespace

FieldBundle::FieldBundle(const GeodesicGraph& graph)
    : graph_(graph),
      distances_(graph.num_vertices()),
      shortened_(graph.num_vertices(), 0),
      order_(graph.num_vertices()) {}

void FieldBundle::run(std::span<const int> sources, std::span<const float> nearness,
                      std::span<float* const> fields) {
  Distances none;
  std::ranges::fill(none.from, std::numeric_limits<float>::infinity());
  std::ranges::fill(distances_, none);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    distances_[sources[i]].from[i] = 0;
    shortened_[sources[i]] = 1;
  }
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::sort(order_, [&](int a, int b) {
    return nearness[a] != nearness[b] ? nearness[a] < nearness[b] : a < b;
  });
  // Inwards first, so that what goes outwards starts with the right distances.
  for (bool inwards = true, outwards = true; inwards || outwards;) {
    inwards = sweep(order_.rbegin(), order_.rend());
    outwards = sweep(order_.begin(), order_.end());
  }
  for (std::size_t i = 0; i < sources.size(); ++i)
    for (std::size_t v = 0; v < order_.size(); ++v) fields[i][v] = distances_[v].from[i];
}

/// Visits the vertices whose distances became shorter; whether there were any.
template <class Iterator>
bool FieldBundle::sweep(Iterator first, Iterator last) {
  bool any = false;
  for (; first != last; ++first) {
    const int v = *first;
    if (!shortened_[v]) continue;
    shortened_[v] = 0;
    any = true;
    relax(distances_[v], graph_.arcs(v), distances_.data(), shortened_.data());
  }
  return any;
}

}  // namespace isomatch
