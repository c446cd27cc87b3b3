// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/nearest_rows.h"

#include <algorithm>

#include "parallel.h"

namespace isomatch::spectral {
namespace {

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Rows split into their first columns, which leave few of them to look at, and the rest.
struct SplitRows {
  Eigen::MatrixXf first;
  RowMatrix rest;

  SplitRows(const Eigen::MatrixXf& rows, Eigen::Index columns)
      : first(rows.leftCols(columns)), rest(rows.rightCols(rows.cols() - columns)) {}
};

/// The row of `rest` that is nearest to `query`, where `first` has the squared distances in the
/// other columns, less a constant. What is farther in these than the nearest in all is left out.
int nearest_row(const Eigen::VectorXf& first, const RowMatrix& rest,
                const Eigen::RowVectorXf& query) {
  const auto distance = [&](Eigen::Index row) {
    return first[row] + (rest.row(row) - query).squaredNorm();
  };
  Eigen::Index nearest = 0;
  first.minCoeff(&nearest);
  float least = distance(nearest);
  for (Eigen::Index row = 0; row < first.size(); ++row) {
    if (first[row] > least) continue;
    const float d = distance(row);
    if (d > least || (d == least && row >= nearest)) continue;
    least = d;
    nearest = row;
  }
  return static_cast<int>(nearest);
}

}  // namespace

std::vector<int> nearest_rows(const Eigen::MatrixXf& queries, const Eigen::MatrixXf& points,
                              const Context& context) {
  constexpr int kBlock = 64;
  // Functions of low frequency tell most: a quarter of them leaves few rows to look at.
  constexpr Eigen::Index kShare = 4;
  const Eigen::Index columns = std::min(points.cols(), points.cols() / kShare + 8);
  const SplitRows from(queries, columns), to(points, columns);
  const Eigen::VectorXf norms = to.first.rowwise().squaredNorm();
  const int n = static_cast<int>(queries.rows());
  std::vector<int> nearest(n);
  parallel_for((n + kBlock - 1) / kBlock, context, [&](std::ptrdiff_t block) {
    const int begin = static_cast<int>(block) * kBlock, count = std::min(kBlock, n - begin);
    Eigen::MatrixXf distances = -2 * to.first * from.first.middleRows(begin, count).transpose();
    distances.colwise() += norms;
    for (int i = 0; i < count; ++i)
      nearest[begin + i] = nearest_row(distances.col(i), to.rest, from.rest.row(begin + i));
  });
  return nearest;
}

}  // namespace isomatch::spectral
