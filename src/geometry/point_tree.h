// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <nanoflann.hpp>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// A k-d tree over points, to which it keeps a reference. Building costs O(N log N).
class PointTree {
 public:
  explicit PointTree(const std::vector<Point>& points) : points_(points), index_(3, *this) {
    index_.buildIndex();
  }

  /// Indices of the K nearest points, nearest first; returns how many there are.
  template <std::size_t K>
  std::size_t nearest(const Point& query, std::array<std::size_t, K>& indices) const {
    std::array<double, K> squared_distances;
    return index_.knnSearch(query.data(), K, indices.data(), squared_distances.data());
  }

  // What nanoflann asks for.
  std::size_t kdtree_get_point_count() const { return points_.size(); }
  double kdtree_get_pt(std::size_t index, std::size_t axis) const { return points_[index][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

 private:
  using Metric = nanoflann::L2_Simple_Adaptor<double, PointTree>;
  const std::vector<Point>& points_;
  nanoflann::KDTreeSingleIndexAdaptor<Metric, PointTree, 3, std::size_t> index_;
};

}  // namespace isomatch
