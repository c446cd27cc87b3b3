// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/closest_point.h"

#include <algorithm>
#include <cmath>

namespace isomatch {

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

ClosestPoint closest_point(const Mesh& mesh, int face, const Point& p) {
  const auto& [a, b, c] = mesh.faces[face];
  const auto& x = mesh.vertices;
  ClosestPoint result{{face, closest_weights(p, x[a], x[b], x[c])}, 0};
  result.squared_distance = (position(mesh, result.point) - p).squaredNorm();
  // Where the face is degenerate, its first corner stands for all of it.
  if (std::isfinite(result.squared_distance)) return result;
  return {{face, {1, 0, 0}}, (x[a] - p).squaredNorm()};
}

SurfacePoint closest_point_around(const Mesh& mesh, const IndexLists& vertex_faces, int vertex,
                                  const Point& p) {
  const auto& x = mesh.vertices;
  SurfacePoint best{vertex_faces[vertex].front(), {}};
  const Face& first = mesh.faces[best.face];
  best.weights[std::ranges::find(first, vertex) - first.begin()] = 1;
  double least = (x[vertex] - p).squaredNorm();
  for (int f : vertex_faces[vertex]) {
    const auto& [a, b, c] = mesh.faces[f];
    const SurfacePoint candidate{f, closest_weights(p, x[a], x[b], x[c])};
    const double distance = (position(mesh, candidate) - p).squaredNorm();
    if (!(distance < least)) continue;  // Nor if a degenerate face makes it no number.
    least = distance;
    best = candidate;
  }
  return best;
}

}  // namespace isomatch
