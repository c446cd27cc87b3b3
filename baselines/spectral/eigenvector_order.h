// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isomatch/context.h"

namespace isomatch::baselines {

/// Which coordinate of one embedding a coordinate of another is, and with which sign.
struct SignedOrder {
  std::vector<int> column;
  std::vector<int> sign;

  /// The columns of `points` in this order, with these signs.
  Eigen::MatrixXd applied(const Eigen::MatrixXd& points) const;
};

/// The order and signs of the columns of `source` that bring it closest to `target`: the least sum
/// of the mean distances from each point to the nearest of the other set. All k! 2^k are tried; the
/// first of equally good ones. O(k! 2^k k |source| |target|).
SignedOrder best_signed_order(const Eigen::MatrixXd& source, const Eigen::MatrixXd& target,
                              const Context& context);

}  // namespace isomatch::baselines
