// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/correspondence.h"
#include "tracked/hypotheses/node_directions.h"
#include "tracked/options.h"
#include "tracked/shape/proxy.h"

namespace isomatch::tracked {

/// A rigid motion under which parts of two shapes lie on each other.
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Point shift{0, 0, 0};
  /// Area of the source that comes to lie on the target, less where it lies less closely.
  double overlap = 0;

  Point operator()(const Point& p) const { return rotation * p + shift; }
};

/// Where a pose takes points.
std::vector<Point> posed(const Pose& pose, std::vector<Point> points);

/// Motions under which much of the source lies on the target, the most first: votes of pairs of
/// points with normals (Drost et al. 2010), then iterated closest points. Normals have to agree
/// with their signs. O(source points^2 * target points).
std::vector<Pose> find_poses(const Proxy& source, const Proxy& target, const PoseOptions& options);

/// The landmarks that a pose takes close to one of the target's.
Correspondence matches_under(const Pose& pose, const Proxy& source, const NodeDirections& from,
                             const Proxy& target, const NodeDirections& onto,
                             const PoseOptions& options);

}  // namespace isomatch::tracked
