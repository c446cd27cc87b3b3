// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>

namespace isomatch::baselines {

/// A smoothing spline from R^k to R^k: affine plus a sum of radial functions -|x - c| about
/// centres. It trades off closeness to the data against bending; affine maps bend nothing.
class ThinPlateSpline {
 public:
  /// Takes rows of `centres` (n x k, n > k) close to rows of `values`. `smoothing` is relative to
  /// the mean distance between centres: 0 interpolates distinct centres, infinity would be affine
  /// least squares.
  ThinPlateSpline(const Eigen::MatrixXd& centres, const Eigen::MatrixXd& values, double smoothing);

  /// The images of rows of `points`.
  Eigen::MatrixXd operator()(const Eigen::MatrixXd& points) const;

 private:
  Eigen::MatrixXd centres_;
  /// Of the radial functions, then of the affine part.
  Eigen::MatrixXd coefficients_;
};

}  // namespace isomatch::baselines
