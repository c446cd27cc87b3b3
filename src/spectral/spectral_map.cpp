// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/spectral_map.h"

#include <algorithm>

#include "spectral/nearest_rows.h"

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

}  // namespace

std::vector<int> refine(const Samples& source, const Samples& target, const Eigenbasis& basis,
                        const TwoWayMap& map, const Samples& wanted, int size,
                        const Context& context) {
  size = std::min(
      {size, static_cast<int>(wanted.functions.cols()), static_cast<int>(basis.functions.cols())});
  const Eigen::MatrixXf c = functional_map(source, target, basis, map, size);
  return nearest_rows(wanted.functions.leftCols(size),
                      basis.functions.leftCols(size) * c.transpose(), context);
}

}  // namespace isomatch::spectral
