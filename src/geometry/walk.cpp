// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/walk.h"

#include <limits>

#include "geometry/closest_point.h"

namespace isomatch {

int walk_to_vertex(const Mesh& mesh, const IndexLists& vertex_faces, int start, const Point& p) {
  int best = start, at = -1;
  double least = (mesh.vertices[start] - p).squaredNorm();
  while (best != at) {
    at = best;
    for (int f : vertex_faces[at]) {
      for (int v : mesh.faces[f]) {
        const double distance = (mesh.vertices[v] - p).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = v;
      }
    }
  }
  return best;
}

SurfacePoint walk_to_point(const Mesh& mesh, const IndexLists& vertex_faces,
                           std::span<const int> starts, const Point& p) {
  ClosestPoint best{{}, std::numeric_limits<double>::infinity()};
  const auto try_face = [&](int face) {
    const ClosestPoint candidate = closest_point(mesh, face, p);
    if (candidate.squared_distance < best.squared_distance) best = candidate;
  };
  for (int face : starts) try_face(face);
  for (int at = kNoFace; at != best.point.face;) {
    at = best.point.face;
    for (int v : mesh.faces[at])
      for (int face : vertex_faces[v]) try_face(face);
  }
  return best.point;
}

}  // namespace isomatch
