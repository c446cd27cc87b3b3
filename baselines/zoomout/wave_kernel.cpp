// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "zoomout/wave_kernel.h"

#include <algorithm>
#include <cmath>

namespace isomatch::baselines {

Eigen::MatrixXd wave_kernel_signatures(const Eigen::MatrixXd& functions,
                                       const Eigen::VectorXd& values, int energies) {
  // The authors' range of energies and width of the Gaussian.
  constexpr double kTop = 1.02, kWidth = 6;
  const Eigen::Index count = values.size() - 1;
  const Eigen::VectorXd logs = values.tail(count).array().max(1e-6).log();
  const Eigen::VectorXd steps =
      Eigen::VectorXd::LinSpaced(energies, logs[0], logs[count - 1] / kTop);
  const double sigma = kWidth * (steps[energies - 1] - steps[0]) / std::max(1, energies - 1);
  // A column for each energy, normalised to weights that sum to one.
  Eigen::MatrixXd weights(count, energies);
  for (int e = 0; e < energies; ++e) {
    weights.col(e) = (-(steps[e] - logs.array()).square() / (2 * sigma * sigma)).exp();
    weights.col(e) /= weights.col(e).sum();
  }
  return functions.rightCols(count).cwiseAbs2() * weights;
}

}  // namespace isomatch::baselines
