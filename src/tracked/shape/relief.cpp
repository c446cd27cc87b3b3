// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/relief.h"

#include "tracked/shape/heat_flow.h"

namespace isomatch::tracked {

std::vector<std::array<double, elastic::kReliefs>> relief(
    const Mesh& mesh, const std::vector<Point>& normals,
    const std::array<double, elastic::kReliefs>& scales) {
  Eigen::MatrixXd positions(mesh.num_vertices(), 3);
  for (int v = 0; v < mesh.num_vertices(); ++v) positions.row(v) = mesh.vertices[v].transpose();
  HeatFlow flow(mesh);
  const Eigen::MatrixXd integrals = flow.integrals(positions);
  std::vector<std::array<double, elastic::kReliefs>> features(mesh.vertices.size());
  for (int k = 0; k < elastic::kReliefs; ++k) {
    flow.set_length(scales[k]);
    const Eigen::MatrixXd smooth = flow.step(integrals);
    for (int v = 0; v < mesh.num_vertices(); ++v)
      features[v][k] = normals[v].dot((positions.row(v) - smooth.row(v)).transpose()) / scales[k];
  }
  return features;
}

}  // namespace isomatch::tracked
