// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/foot.h"

#include <algorithm>

#include "geometry/closest_point.h"

namespace isomatch::elastic {
namespace {

Foot foot_at(int vertex, const Mesh& mesh, const IndexLists& vertex_faces) {
  Foot foot;
  foot.face = vertex_faces[vertex].front();
  const Face& face = mesh.faces[foot.face];
  foot.weights[std::ranges::find(face, vertex) - face.begin()] = 1;
  foot.position = mesh.vertices[vertex];
  return foot;
}

}  // namespace

Foot foot_around(int vertex, const Point& position, const Mesh& mesh,
                 const IndexLists& vertex_faces, const std::vector<Point>& normals) {
  Foot best = foot_at(vertex, mesh, vertex_faces);
  double least = (best.position - position).squaredNorm();
  for (int f : vertex_faces[vertex]) {
    const Face& face = mesh.faces[f];
    const auto& p = mesh.vertices;
    const auto weights = closest_weights(position, p[face[0]], p[face[1]], p[face[2]]);
    const Point foot = weights[0] * p[face[0]] + weights[1] * p[face[1]] + weights[2] * p[face[2]];
    const double distance = (foot - position).squaredNorm();
    if (!(distance < least)) continue;  // Nor if a degenerate face makes it no number.
    least = distance;
    best = {f, weights, foot, Point::Zero()};
  }
  const Face& face = mesh.faces[best.face];
  for (int k = 0; k < 3; ++k) best.normal += best.weights[k] * normals[face[k]];
  best.normal.normalize();
  return best;
}

}  // namespace isomatch::elastic
