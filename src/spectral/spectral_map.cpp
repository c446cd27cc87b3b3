// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/spectral_map.h"

#include <algorithm>

namespace isomatch::spectral {
namespace {

/// Rows of `functions`, one for each index.
Eigen::MatrixXf pulled_back(const Eigen::MatrixXf& functions, const std::vector<int>& rows,
                            int size) {
  Eigen::MatrixXf pulled(rows.size(), size);
  for (std::size_t i = 0; i < rows.size(); ++i) pulled.row(i) = functions.row(rows[i]).head(size);
  return pulled;
}

/// Functional map that takes the first `size` target coefficients to source coefficients.
Eigen::MatrixXf functional_map(const Samples& source, const Samples& target,
                               const Eigenbasis& basis, const TwoWayMap& map, int size) {
  const Eigen::MatrixXf forth =
      source.functions.leftCols(size).transpose() *
      (source.areas.asDiagonal() * pulled_back(basis.functions, map.forth, size));
  const Eigen::MatrixXf back = pulled_back(source.functions, map.back, size).transpose() *
                               (target.areas.asDiagonal() * target.functions.leftCols(size));
  return 0.5F * (forth + back);
}

/// For each sample the row of `points` that is nearest.
std::vector<int> nearest_rows(const Eigen::MatrixXf& samples, const Eigen::MatrixXf& points) {
  constexpr int kBlock = 64;
  const Eigen::VectorXf norms = points.rowwise().squaredNorm();
  const int n = static_cast<int>(samples.rows());
  std::vector<int> map(n);
  for (int first = 0; first < n; first += kBlock) {
    const int count = std::min(kBlock, n - first);
    Eigen::MatrixXf distances = -2 * points * samples.middleRows(first, count).transpose();
    distances.colwise() += norms;
    for (int i = 0; i < count; ++i) {
      Eigen::Index nearest = 0;
      distances.col(i).minCoeff(&nearest);
      map[first + i] = static_cast<int>(nearest);
    }
  }
  return map;
}

}  // namespace

std::vector<int> refine(const Samples& source, const Samples& target, const Eigenbasis& basis,
                        const TwoWayMap& map, const Samples& wanted, int size) {
  size = std::min(
      {size, static_cast<int>(wanted.functions.cols()), static_cast<int>(basis.functions.cols())});
  const Eigen::MatrixXf c = functional_map(source, target, basis, map, size);
  return nearest_rows(wanted.functions.leftCols(size),
                      basis.functions.leftCols(size) * c.transpose());
}

}  // namespace isomatch::spectral
