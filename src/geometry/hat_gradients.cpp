// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/hat_gradients.h"

#include <Eigen/Geometry>

namespace isomatch {

Point area_vector(const std::vector<Point>& positions, const Face& face) {
  return (positions[face[1]] - positions[face[0]]).cross(positions[face[2]] - positions[face[0]]);
}

std::array<Point, 3> hat_gradients(const Mesh& mesh, const Face& face) {
  const Point normal = area_vector(mesh.vertices, face).normalized();
  std::array<Point, 3> gradients;
  for (int k = 0; k < 3; ++k) {
    const Point edge = mesh.vertices[face[(k + 2) % 3]] - mesh.vertices[face[(k + 1) % 3]];
    gradients[k] = 0.5 * normal.cross(edge);
  }
  return gradients;
}

}  // namespace isomatch
