// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isomatch/context.h"

namespace isomatch::spectral {

/// For each row of `queries` the row of `points` that is nearest to it, the first of equally near
/// ones. Both have as many columns. Brute force on matrix products: O(|queries| |points| columns).
std::vector<int> nearest_rows(const Eigen::MatrixXf& queries, const Eigen::MatrixXf& points,
                              const Context& context);

}  // namespace isomatch::spectral
