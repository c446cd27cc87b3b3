// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/spectral_map.h"

#include <algorithm>

namespace isomatch::spectral {
namespace {

/// Functional map that takes the first `size` target coefficients to source coefficients.
Eigen::MatrixXf functional_map(const Samples& source, const Eigenbasis& target,
                               const std::vector<int>& map, int size) {
  Eigen::MatrixXf pulled(map.size(), size);
  for (std::size_t i = 0; i < map.size(); ++i)
    pulled.row(i) = target.functions.row(map[i]).head(size);
  return source.functions.leftCols(size).transpose() * (source.areas.asDiagonal() * pulled);
}

/// For each sample the row of `points` that is nearest.
std::vector<int> nearest_rows(const Eigen::MatrixXf& samples, const Eigen::MatrixXf& points,
                              const Context& context) {
  constexpr int kBlock = 64;
  const Eigen::VectorXf norms = points.rowwise().squaredNorm();
  const int n = static_cast<int>(samples.rows());
  std::vector<int> map(n);
#pragma omp parallel for schedule(static) num_threads(context.threads)
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

std::vector<int> refine(const Samples& source, const Eigenbasis& target,
                        const std::vector<int>& map, int size, const Context& context) {
  size = std::min(
      {size, static_cast<int>(source.functions.cols()), static_cast<int>(target.functions.cols())});
  const Eigen::MatrixXf c = functional_map(source, target, map, size);
  return nearest_rows(source.functions.leftCols(size),
                      target.functions.leftCols(size) * c.transpose(), context);
}

}  // namespace isomatch::spectral
