// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

namespace isomatch::baselines {

/// Injective assignments of source points to candidates, of small stress between the distances
/// `wanted` (source, the first `points` rows) and `given` (candidates): points are assigned in
/// order, the `beam` least stressed partial assignments stay. At most `count`, best first, ties in
/// lexicographic order.
std::vector<std::vector<int>> coarse_assignments(const Eigen::MatrixXd& wanted, int points,
                                                 const Eigen::MatrixXd& given, int beam, int count);

}  // namespace isomatch::baselines
