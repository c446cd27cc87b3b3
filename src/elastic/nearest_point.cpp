// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/nearest_point.h"

#include <array>
#include <nanoflann.hpp>
#include <tuple>

namespace isomatch::elastic {
namespace {

/// A point such that the distance of two is what their positions and all other differences, as
/// weighted, amount to.
using Coordinates = std::array<double, 6 + kFeatures>;

Coordinates coordinates(const Point& position, const Point& normal, const Features& features,
                        const ProjectionWeights& weights) {
  Coordinates result{};
  for (int k = 0; k < 3; ++k) {
    result[k] = position[k];
    result[3 + k] = weights.normal * normal[k];
  }
  for (int k = 0; k < kReliefs; ++k) result[6 + k] = weights.relief * features.relief[k];
  for (int k = 0; k < kPlaces; ++k) result[6 + kReliefs + k] = weights.place * features.place[k];
  return result;
}

}  // namespace

struct NearestPoint::Index {
  static constexpr int kDimensions = std::tuple_size_v<Coordinates>;
  using Distance = nanoflann::L2_Simple_Adaptor<double, Index>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Distance, Index, kDimensions>;

  std::vector<Coordinates> points;
  std::unique_ptr<Tree> tree;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t k) const { return points[i][k]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

NearestPoint::NearestPoint(const std::vector<Point>& positions, const std::vector<Point>& normals,
                           const std::vector<Features>& features, const ProjectionWeights& weights)
    : weights_(weights), index_(std::make_unique<Index>()) {
  index_->points.reserve(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v)
    index_->points.push_back(coordinates(positions[v], normals[v], features[v], weights));
  index_->tree = std::make_unique<Index::Tree>(Index::kDimensions, *index_);
}

NearestPoint::~NearestPoint() = default;

int NearestPoint::operator()(const Point& position, const Point& normal,
                             const Features& features) const {
  const Coordinates query = coordinates(position, normal, features, weights_);
  unsigned int nearest = 0;
  double distance = 0;
  index_->tree->knnSearch(query.data(), 1, &nearest, &distance);
  return static_cast<int>(nearest);
}

}  // namespace isomatch::elastic
