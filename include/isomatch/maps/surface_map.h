// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <vector>

#include "isomatch/maps/correspondence.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// A point on a triangle mesh: a face and the barycentric weights of its corners, in their order.
/// Weights are in [0, 1] and sum to 1. `face` is `kNoFace` if there is no such point.
struct SurfacePoint {
  int face = -1;
  std::array<double, 3> weights{};

  bool operator==(const SurfacePoint&) const = default;
};

/// A map from every vertex of one mesh to a point on another, always named by its direction, as in
/// `source_to_target`.
using SurfaceMap = std::vector<SurfacePoint>;

/// Where `point`, which must have a face, lies in space.
Point position(const Mesh& mesh, const SurfacePoint& point);

/// Throws `InvalidInput` unless `map` has a point, or none, on one of so many faces for each of
/// `from_vertices`.
void check_map(const SurfaceMap& map, int from_vertices, int onto_faces);
/// Likewise for one of so many vertices, or `kUnmatched`.
void check_map(const VertexMap& map, int from_vertices, int onto_vertices);

/// The vertex with the largest weight of a point that has a face, the first of equal ones.
int heaviest_corner(const Mesh& mesh, const SurfacePoint& point);

/// The vertex with the largest weight of each point (the first of equal ones), `kUnmatched` where
/// there is none.
VertexMap nearest_vertices(const Mesh& mesh, const SurfaceMap& map);

/// Each vertex of `mesh` as a point: a corner of its first face. Vertices without a face have none.
SurfaceMap corner_points(const Mesh& mesh);

/// A map to vertices of `target` as one to points.
SurfaceMap corner_points(const Mesh& target, const VertexMap& source_to_target);

}  // namespace isomatch
