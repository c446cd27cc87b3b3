// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>

#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {

/// Barycentric weights of the point of a triangle that is closest to `p` (Ericson 2005); not finite
/// if the triangle is degenerate.
std::array<double, 3> closest_weights(const Point& p, const Point& a, const Point& b,
                                      const Point& c);

struct ClosestPoint {
  SurfacePoint point;
  double squared_distance;
};

/// The point of a face, degenerate or not, that is closest to `p`.
ClosestPoint closest_point(const Mesh& mesh, int face, const Point& p);

/// The point of the faces around `vertex` that is closest to `p`; `vertex` itself, on the first of
/// them, if none is closer. Degenerate faces do not count.
SurfacePoint closest_point_around(const Mesh& mesh, const IndexLists& vertex_faces, int vertex,
                                  const Point& p);

}  // namespace isomatch
