// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/ground_truth.h"

#include <array>
#include <nanoflann.hpp>

namespace isomatch::synth {

/// A kd-tree over the points.
class SurfaceLookup::Tree {
 public:
  explicit Tree(const std::vector<Point>& points) : points_(points), index_(3, *this) {
    index_.buildIndex();
  }

  /// Indices of the K nearest points, nearest first; returns how many there are.
  template <std::size_t K>
  std::size_t nearest(const Point& query, std::array<std::size_t, K>& indices) const {
    std::array<double, K> squared_distances;
    return index_.knnSearch(query.data(), K, indices.data(), squared_distances.data());
  }

  std::size_t kdtree_get_point_count() const { return points_.size(); }
  double kdtree_get_pt(std::size_t index, std::size_t axis) const { return points_[index][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

 private:
  using Metric = nanoflann::L2_Simple_Adaptor<double, Tree>;
  const std::vector<Point>& points_;
  nanoflann::KDTreeSingleIndexAdaptor<Metric, Tree, 3, std::size_t> index_;
};

SurfaceLookup::SurfaceLookup(const Body& body, const std::vector<Point>& rest,
                             const Context& context)
    : body_(&body), rest_(&rest), context_(&context), tree_(std::make_unique<Tree>(rest)) {}

SurfaceLookup::~SurfaceLookup() = default;

int SurfaceLookup::nearest(const Point& query) const {
  std::array<std::size_t, 8> candidates;
  const std::size_t count = tree_->nearest(query, candidates);
  const Vector normal = body_->normal(query);
  for (std::size_t i = 0; i < count; ++i) {
    if (body_->normal((*rest_)[candidates[i]]).dot(normal) > 0.2)
      return static_cast<int>(candidates[i]);
  }
  return static_cast<int>(candidates[0]);
}

std::vector<int> SurfaceLookup::nearest(const std::vector<Point>& queries) const {
  std::vector<int> result(queries.size());
#pragma omp parallel for num_threads(context_->threads) schedule(static)
  for (std::size_t i = 0; i < queries.size(); ++i) result[i] = nearest(queries[i]);
  return result;
}

}  // namespace isomatch::synth
