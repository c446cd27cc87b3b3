// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "carry/welded.h"

#include "io/mesh/point_index.h"

namespace isomatch::transfer {

WeldedMesh weld(const Mesh& mesh) {
  mesh_io::PointIndex index;
  WeldedMesh result{{{}, mesh.faces}, {}};
  result.vertex.reserve(mesh.vertices.size());
  for (const Point& p : mesh.vertices) result.vertex.push_back(index.number_of(p));
  result.mesh.vertices = index.take_points();
  for (Face& face : result.mesh.faces)
    for (int& v : face) v = result.vertex[v];
  return result;
}

}  // namespace isomatch::transfer
