// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include "tracked/shape/proxy.h"

namespace isomatch::tracked {

/// Some nodes of a proxy, the distances between them and the directions in which one sees another.
class NodeDirections {
 public:
  /// `nodes` without repetition. O(|nodes|^2).
  NodeDirections(const Proxy& proxy, std::vector<int> nodes);

  int size() const { return static_cast<int>(nodes_.size()); }
  int node(int landmark) const { return nodes_[landmark]; }
  bool oriented() const { return oriented_; }
  float distance(int a, int b) const { return distances_(a, b); }
  /// Distances from `a` to all landmarks.
  std::span<const float> distances_from(int a) const {
    return {distances_.row(a).data(), nodes_.size()};
  }
  /// The least that these are on the whole shape.
  std::span<const float> least_distances_from(int a) const {
    return {least_.row(a).data(), nodes_.size()};
  }
  /// Unit direction at `a` in which the shortest path to `b` leaves, in a frame of the tangent
  /// plane that is right-handed seen from outside. Zero where there is none.
  std::complex<float> direction(int a, int b) const { return directions_[a * nodes_.size() + b]; }

 private:
  std::vector<int> nodes_;
  bool oriented_;
  FloatMatrix distances_, least_;
  std::vector<std::complex<float>> directions_;
};

/// What two distances differ by, each of which is between a least and a most on the whole shape;
/// what may be due to what is missing counts as `doubt` says.
inline float doubted(float least_a, float most_a, float least_b, float most_b, float doubt) {
  const float sure = std::max({0.0F, least_b - most_a, least_a - most_b});
  return sure + doubt * (std::abs(most_a - most_b) - sure);
}

/// The same of the distances between two landmarks each.
inline float doubted_difference(const NodeDirections& source, std::array<int, 2> from,
                                const NodeDirections& target, std::array<int, 2> onto,
                                float doubt) {
  return doubted(source.least_distances_from(from[0])[from[1]], source.distance(from[0], from[1]),
                 target.least_distances_from(onto[0])[onto[1]], target.distance(onto[0], onto[1]),
                 doubt);
}

}  // namespace isomatch::tracked
