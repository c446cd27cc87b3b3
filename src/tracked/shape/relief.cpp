// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/relief.h"

#include <Eigen/SparseCholesky>

#include "geometry/cotangent_laplacian.h"
#include "isomatch/error.h"

namespace isomatch::tracked {

std::vector<std::array<double, elastic::kReliefs>> relief(
    const Mesh& mesh, const std::vector<Point>& normals,
    const std::array<double, elastic::kReliefs>& scales) {
  const std::vector<double> areas = vertex_areas(mesh);
  const Eigen::SparseMatrix<double> laplacian = cotangent_laplacian(mesh);
  Eigen::MatrixX3d positions(mesh.num_vertices(), 3), weighted(mesh.num_vertices(), 3);
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    positions.row(v) = mesh.vertices[v].transpose();
    weighted.row(v) = areas[v] * positions.row(v);
  }
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  solver.analyzePattern(laplacian);
  std::vector<std::array<double, elastic::kReliefs>> features(mesh.vertices.size());
  for (int k = 0; k < elastic::kReliefs; ++k) {
    Eigen::SparseMatrix<double> system = laplacian * (scales[k] * scales[k]);
    for (int v = 0; v < mesh.num_vertices(); ++v) system.coeffRef(v, v) += areas[v];
    solver.factorize(system);
    if (solver.info() != Eigen::Success) throw SolverFailure("a surface cannot be smoothed");
    const Eigen::MatrixX3d smooth = solver.solve(weighted);
    for (int v = 0; v < mesh.num_vertices(); ++v)
      features[v][k] = normals[v].dot((positions.row(v) - smooth.row(v)).transpose()) / scales[k];
  }
  return features;
}

}  // namespace isomatch::tracked
