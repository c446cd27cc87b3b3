// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/SparseCholesky>

#include "isomatch/mesh/mesh.h"

namespace isomatch::tracked {

/// Heat flow over a mesh, in implicit steps.
class HeatFlow {
 public:
  explicit HeatFlow(const Mesh& mesh);

  /// A step averages over `length` from now on. O(N^1.5). Throws `SolverFailure` if the mesh is too
  /// badly shaped.
  void set_length(double length);

  /// Values at the vertices (rows), integrated over their areas.
  Eigen::MatrixXd integrals(const Eigen::MatrixXd& values) const;
  /// Values after a step from these integrals; after `set_length`.
  Eigen::MatrixXd step(const Eigen::MatrixXd& integrals) const { return solver_.solve(integrals); }

 private:
  Eigen::VectorXd areas_;
  Eigen::SparseMatrix<double> laplacian_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace isomatch::tracked
