// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/cotangent_laplacian.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace isomatch {

double corner_angle(const Mesh& mesh, const Face& face, int corner) {
  const Point& apex = mesh.vertices[face[corner]];
  const Point u = mesh.vertices[face[(corner + 1) % 3]] - apex;
  const Point w = mesh.vertices[face[(corner + 2) % 3]] - apex;
  return std::atan2(u.cross(w).norm(), u.dot(w));
}

double cotangent_weight(const Mesh& mesh, const Face& face, int corner) {
  return std::clamp(0.5 / std::tan(corner_angle(mesh, face, corner)), 0.0, 10.0);
}

Eigen::SparseMatrix<double, Eigen::RowMajor> cotangent_laplacian(const Mesh& mesh) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(mesh.faces.size() * 12);
  for (const Face& face : mesh.faces) {
    for (int corner = 0; corner < 3; ++corner) {
      const int a = face[(corner + 1) % 3], b = face[(corner + 2) % 3];
      const double weight = cotangent_weight(mesh, face, corner);
      entries.emplace_back(a, b, -weight);
      entries.emplace_back(b, a, -weight);
      entries.emplace_back(a, a, weight);
      entries.emplace_back(b, b, weight);
    }
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> laplacian(mesh.num_vertices(), mesh.num_vertices());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

}  // namespace isomatch
