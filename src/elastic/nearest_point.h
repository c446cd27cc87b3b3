// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <vector>

#include "elastic/features.h"
#include "geometry/kd_tree.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch::elastic {

/// Finds the point of a set that is closest in position, normal and features; of equally close ones
/// the first.
class NearestPoint {
 public:
  NearestPoint(const std::vector<Point>& positions, const std::vector<Point>& normals,
               const std::vector<Features>& features, const ProjectionWeights& weights);

  /// Found sooner if `guess` is near; it is none if it is negative.
  int operator()(const Point& position, const Point& normal, const Features& features,
                 int guess = -1) const;

 private:
  using Tree = KdTree<6 + kFeatures>;
  /// Such that the distance of two is what their positions and all other differences, as weighted,
  /// amount to.
  using Coordinates = Tree::Coordinates;

  Coordinates coordinates(const Point& position, const Point& normal,
                          const Features& features) const;

  ProjectionWeights weights_;
  std::vector<Coordinates> points_;
  std::optional<Tree> tree_;
};

}  // namespace isomatch::elastic
