// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/hat_gradients.h"

#include <Eigen/Geometry>

namespace isomatch {

Point area_vector(const Mesh& mesh, const Face& face) {
  const Point& p = mesh.vertices[face[0]];
  return (mesh.vertices[face[1]] - p).cross(mesh.vertices[face[2]] - p);
}

std::array<Point, 3> hat_gradients(const Mesh& mesh, const Face& face) {
  const Point normal = area_vector(mesh, face).normalized();
  std::array<Point, 3> gradients;
  for (int k = 0; k < 3; ++k) {
    const Point edge = mesh.vertices[face[(k + 2) % 3]] - mesh.vertices[face[(k + 1) % 3]];
    gradients[k] = 0.5 * normal.cross(edge);
  }
  return gradients;
}

}  // namespace isomatch
