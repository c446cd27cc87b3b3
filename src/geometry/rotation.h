// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

Point mean_of(std::span<const Point> points);

/// The rotation R, never a reflection, that turns vectors a_i onto b_i as well as possible: it
/// minimises the sum of |b_i - R a_i|^2, where `covariance` is the sum of b_i a_i^T (Kabsch 1976).
/// The identity if the vectors determine none, because all lie on a line.
Eigen::Matrix3d best_rotation(const Eigen::Matrix3d& covariance);

/// The same between point sets, each around its mean. Throws `InvalidInput` if they are not of one
/// size.
Eigen::Matrix3d best_rotation(std::span<const Point> from, std::span<const Point> to);

}  // namespace isomatch
