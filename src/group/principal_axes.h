// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "group/alignment.h"

namespace isomatch {

/// Principal components of shapes, largest variance first.
struct PrincipalAxes {
  /// N - 1 in the denominator.
  Eigen::VectorXd variances;
  /// N x K.
  Eigen::MatrixXd scores;
};

/// Rows minus their mean.
ShapeRows deviations_from(const Eigen::RowVectorXd& mean, const ShapeRows& rows);

/// All axes whose variance is above 1e-10 of the largest and above `least`, the least that is not
/// taken for rounding; of N deviations with mean 0.
PrincipalAxes principal_axes(const ShapeRows& deviations, double least);

/// The first `count` axes as unit vectors, count x 3P.
Eigen::MatrixXd axis_directions(const ShapeRows& deviations, const PrincipalAxes& axes,
                                Eigen::Index count);

/// Variance below which shapes around `mean` are taken for the same.
inline double least_variance(const Eigen::RowVectorXd& mean) { return 1e-20 * mean.squaredNorm(); }

}  // namespace isomatch
