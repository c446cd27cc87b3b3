// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/heat_flow.h"

#include <vector>

#include "geometry/cotangent_laplacian.h"
#include "isomatch/error.h"

namespace isomatch::tracked {

HeatFlow::HeatFlow(const Mesh& mesh) : laplacian_(cotangent_laplacian(mesh)) {
  const std::vector<double> areas = vertex_areas(mesh);
  areas_ = Eigen::Map<const Eigen::VectorXd>(areas.data(), std::ssize(areas));
  solver_.analyzePattern(laplacian_);
}

void HeatFlow::set_length(double length) {
  Eigen::SparseMatrix<double> system = laplacian_ * (length * length);
  for (Eigen::Index v = 0; v < areas_.size(); ++v) system.coeffRef(v, v) += areas_[v];
  solver_.factorize(system);
  if (solver_.info() != Eigen::Success) throw SolverFailure("a surface cannot be smoothed");
}

Eigen::MatrixXd HeatFlow::integrals(const Eigen::MatrixXd& values) const {
  return areas_.asDiagonal() * values;
}

}  // namespace isomatch::tracked
