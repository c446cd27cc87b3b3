// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/weld.h"

#include "geometry/point_index.h"

namespace isomatch {

WeldedMesh weld(const Mesh& mesh) {
  PointIndex index;
  WeldedMesh result{{{}, mesh.faces}, {}};
  result.vertex.reserve(mesh.vertices.size());
  for (const Point& p : mesh.vertices) result.vertex.push_back(index.number_of(p));
  result.mesh.vertices = index.take_points();
  for (Face& face : result.mesh.faces)
    for (int& v : face) v = result.vertex[v];
  return result;
}

}  // namespace isomatch
