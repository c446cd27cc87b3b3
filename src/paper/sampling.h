// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/context.h"
#include "shape/metric_surface.h"

namespace isomatch {

/// The base vertices of one shape at one level and what their patches cover (Section 3).
struct BaseSampling {
  /// Sampling radius r(k), over sqrt(area).
  float radius = 0;
  /// S(k) in the order of selection: S(k-1) comes first, so that an index into this list means the
  /// same base vertex at all later levels.
  std::vector<int> bases;
  /// Area of the largest patch, over the area.
  double largest_patch_area = 0;
};

/// Section 3, one level: starts from the `inherited` base vertices and adds the first vertex of
/// `order` that no patch covers until all are covered. New base vertices are more than `radius`
/// apart from all others; every vertex is within `radius` of a base vertex. With radius 0 all
/// vertices become bases, those that coincide as well. Cost: one ball a base.
BaseSampling sample_bases(const MetricSurface& shape, std::span<const int> order,
                          std::span<const int> inherited, float radius,
                          const Context& context = {});

/// The geodesic distances between base vertices that are close to each other.
class BaseNeighbourhoods {
 public:
  struct Neighbour {
    int base;  ///< Index into the list of bases.
    float distance;
  };

  BaseNeighbourhoods() = default;
  /// All pairs of `bases` within `cutoff` of each other. Cost: one ball a base.
  BaseNeighbourhoods(const MetricSurface& shape, std::span<const int> bases, float cutoff,
                     const Context& context = {});

  /// Bases within `cutoff` of `base`, itself included, in ascending order of index.
  std::span<const Neighbour> operator[](int base) const {
    return {neighbours_.data() + offsets_[base], neighbours_.data() + offsets_[base + 1]};
  }
  /// Distance between two bases, or the cutoff if they are farther apart.
  float distance(int a, int b) const;
  float cutoff() const { return cutoff_; }

 private:
  float cutoff_ = 0;
  std::vector<std::size_t> offsets_{0};
  std::vector<Neighbour> neighbours_;
};

/// The base vertices of one shape at one level and the distances among them. Bases are meant by
/// their index, 0-based, in the order of selection.
struct ShapeLevel {
  BaseSampling sampling;
  /// Up to twice the sampling radius of the level before, the extent of a parent patch; at level 0
  /// among all bases.
  BaseNeighbourhoods neighbourhoods;

  int num_bases() const { return static_cast<int>(sampling.bases.size()); }
};

/// One level before anything is matched.
struct SampledLevel {
  ShapeLevel source, target;
  /// Source bases, evenly spaced, whose matches make the list xi' (Section 6). They are bases of
  /// the level before as well, except at level 0.
  std::vector<int> landmarks;
};

}  // namespace isomatch
