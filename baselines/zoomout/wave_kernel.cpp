// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "zoomout/wave_kernel.h"

#include <algorithm>
#include <cmath>

namespace isomatch::baselines {

Eigen::MatrixXd wave_kernel_signatures(const Eigen::MatrixXd& functions,
                                       const Eigen::VectorXd& values, int energies) {
  // Gaussians of this many steps; energies keep two widths away from the ends of the spectrum.
  constexpr double kWidth = 7, kMargin = 2;
  const Eigen::Index count = values.size() - 1;
  const Eigen::VectorXd logs = values.tail(count).array().max(1e-6).log();
  const double sigma = kWidth * (logs[count - 1] - logs[0]) / energies;
  const Eigen::VectorXd steps = Eigen::VectorXd::LinSpaced(energies, logs[0] + kMargin * sigma,
                                                           logs[count - 1] - kMargin * sigma);
  // A column for each energy, normalised to weights that sum to one.
  Eigen::MatrixXd weights(count, energies);
  for (int e = 0; e < energies; ++e) {
    weights.col(e) = (-(steps[e] - logs.array()).square() / (2 * sigma * sigma)).exp();
    weights.col(e) /= weights.col(e).sum();
  }
  return functions.rightCols(count).cwiseAbs2() * weights;
}

}  // namespace isomatch::baselines
