// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/thin_plate.h"

#include <Eigen/QR>

namespace isomatch::baselines {
namespace {

/// -|x - c| of each point (row) and centre (column).
Eigen::MatrixXd kernel(const Eigen::MatrixXd& points, const Eigen::MatrixXd& centres) {
  Eigen::MatrixXd values(points.rows(), centres.rows());
  for (Eigen::Index c = 0; c < centres.rows(); ++c)
    values.col(c) = -(points.rowwise() - centres.row(c)).rowwise().norm();
  return values;
}

}  // namespace

ThinPlateSpline::ThinPlateSpline(const Eigen::MatrixXd& centres, const Eigen::MatrixXd& values,
                                 double smoothing)
    : centres_(centres) {
  const Eigen::Index n = centres.rows(), k = centres.cols();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + k + 1, n + k + 1);
  system.topLeftCorner(n, n) = kernel(centres, centres);
  const double mean_distance = -system.topLeftCorner(n, n).mean();
  system.topLeftCorner(n, n).diagonal().array() += smoothing * mean_distance;
  system.block(0, n, n, k) = centres;
  system.col(n + k).head(n).setOnes();
  system.bottomLeftCorner(k + 1, n) = system.topRightCorner(n, k + 1).transpose();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n + k + 1, k);
  right.topRows(n) = values;
  coefficients_ = system.colPivHouseholderQr().solve(right);
}

Eigen::MatrixXd ThinPlateSpline::operator()(const Eigen::MatrixXd& points) const {
  const Eigen::Index n = centres_.rows(), k = centres_.cols();
  const Eigen::MatrixXd affine = points * coefficients_.middleRows(n, k);
  return (kernel(points, centres_) * coefficients_.topRows(n) + affine).rowwise() +
         coefficients_.row(n + k);
}

}  // namespace isomatch::baselines
