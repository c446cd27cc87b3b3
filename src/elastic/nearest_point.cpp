// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/nearest_point.h"

namespace isomatch::elastic {

NearestPoint::NearestPoint(const std::vector<Point>& positions, const std::vector<Point>& normals,
                           const std::vector<Features>& features, const ProjectionWeights& weights)
    : weights_(weights) {
  points_.reserve(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v)
    points_.push_back(coordinates(positions[v], normals[v], features[v]));
  tree_.emplace(points_);
}

int NearestPoint::operator()(const Point& position, const Point& normal, const Features& features,
                             int guess) const {
  return tree_->nearest(coordinates(position, normal, features), guess);
}

NearestPoint::Coordinates NearestPoint::coordinates(const Point& position, const Point& normal,
                                                    const Features& features) const {
  Coordinates result;
  result.head<3>() = position;
  result.segment<3>(3) = weights_.normal * normal;
  for (int k = 0; k < kReliefs; ++k) result[6 + k] = weights_.relief * features.relief[k];
  for (int k = 0; k < kPlaces; ++k) result[6 + kReliefs + k] = weights_.place * features.place[k];
  return result;
}

}  // namespace isomatch::elastic
