// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

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

}  // namespace isomatch::tracked
