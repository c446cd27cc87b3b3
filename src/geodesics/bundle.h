// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/geodesics/geodesics.h"

namespace isomatch {

/// Distance fields from several sources at once, which share each look at an arc: faster than one
/// after the other where the sources lie close together. The same bytes as from
/// `GeodesicSearch::field`, since both end where no arc shortens any distance. One per thread.
class FieldBundle {
 public:
  /// Sources at a time: as many distances as a line of the cache holds.
  static constexpr int kSources = 16;

  /// The distances of a vertex from all sources.
  struct alignas(64) Distances {
    float from[kSources];
  };

  /// Keeps a reference to `graph`.
  explicit FieldBundle(const GeodesicGraph& graph);

  /// Fields from at most `kSources` of `sources`, the distances from the i-th into `fields[i]`.
  /// `nearness` orders the vertices: distances from a place that is close to all sources.
  void run(std::span<const int> sources, std::span<const float> nearness,
           std::span<float* const> fields);

 private:
  template <class Iterator>
  bool sweep(Iterator first, Iterator last);

  const GeodesicGraph& graph_;
  std::vector<Distances> distances_;
  std::vector<char> shortened_;  ///< Vertices whose arcs have to be looked at (again).
  std::vector<int> order_;
};

}  // namespace isomatch
