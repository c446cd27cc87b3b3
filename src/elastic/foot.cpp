// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/foot.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace isomatch::elastic {
namespace {

/// Barycentric weights of the point of a triangle that is closest to `p` (Ericson 2005).
std::array<double, 3> closest_weights(const Point& p, const Point& a, const Point& b,
                                      const Point& c) {
  const Point ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Point bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const Point cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

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
