// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>

#include "isomatch/maps/surface_map.h"

namespace isomatch {

/// Barycentric weights of the point of a triangle that is closest to `p` (Ericson 2005); not finite
/// if the triangle is degenerate.
std::array<double, 3> closest_weights(const Point& p, const Point& a, const Point& b,
                                      const Point& c);

struct FacePoint {
  SurfacePoint point;
  double squared_distance;
};

/// The point of a face, degenerate or not, that is closest to `p`.
FacePoint closest_point(const Mesh& mesh, int face, const Point& p);

}  // namespace isomatch
