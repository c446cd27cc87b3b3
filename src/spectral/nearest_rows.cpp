// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/nearest_rows.h"

#include <algorithm>

#include "parallel.h"

namespace isomatch::spectral {

std::vector<int> nearest_rows(const Eigen::MatrixXf& queries, const Eigen::MatrixXf& points,
                              const Context& context) {
  constexpr int kBlock = 64;
  const Eigen::VectorXf norms = points.rowwise().squaredNorm();
  const int n = static_cast<int>(queries.rows());
  std::vector<int> nearest(n);
  parallel_for((n + kBlock - 1) / kBlock, context, [&](std::ptrdiff_t block) {
    const int first = static_cast<int>(block) * kBlock, count = std::min(kBlock, n - first);
    Eigen::MatrixXf distances = -2 * points * queries.middleRows(first, count).transpose();
    distances.colwise() += norms;
    for (int i = 0; i < count; ++i) {
      Eigen::Index row = 0;
      distances.col(i).minCoeff(&row);
      nearest[first + i] = static_cast<int>(row);
    }
  });
  return nearest;
}

}  // namespace isomatch::spectral
