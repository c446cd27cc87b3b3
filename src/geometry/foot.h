// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <vector>

#include "isomatch/mesh/mesh.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::elastic {

/// A point on a triangle mesh.
struct Foot {
  int face = -1;
  std::array<double, 3> weights{};
  Point position{0, 0, 0};
  Point normal{0, 0, 0};
};

/// The point of the faces around `vertex` that is closest to `position`. `normals` are those of the
/// vertices.
Foot foot_around(int vertex, const Point& position, const Mesh& mesh,
                 const IndexLists& vertex_faces, const std::vector<Point>& normals);

}  // namespace isomatch::elastic
