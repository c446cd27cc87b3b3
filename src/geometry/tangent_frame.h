// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Geometry>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// Two unit vectors at right angles that span a plane; their cross product is its normal.
struct TangentFrame {
  Point first, second;

  Point vector(const Eigen::Vector2d& t) const { return t.x() * first + t.y() * second; }
  /// Of the projection onto the plane.
  Eigen::Vector2d coordinates(const Point& p) const { return {first.dot(p), second.dot(p)}; }
};

/// Of the plane with that unit normal, turned in it anyhow.
inline TangentFrame tangent_frame(const Point& normal) {
  const Point first = normal.unitOrthogonal();
  return {first, normal.cross(first)};
}

}  // namespace isomatch
