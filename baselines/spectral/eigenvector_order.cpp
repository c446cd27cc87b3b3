// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/eigenvector_order.h"

#include <algorithm>
#include <numeric>

#include "parallel.h"

namespace isomatch::baselines {
namespace {

std::vector<SignedOrder> all_signed_orders(int dimensions) {
  std::vector<int> column(dimensions);
  std::iota(column.begin(), column.end(), 0);
  std::vector<SignedOrder> orders;
  do {
    for (int bits = 0; bits < 1 << dimensions; ++bits) {
      SignedOrder order{column, {}};
      for (int k = 0; k < dimensions; ++k) order.sign.push_back((bits >> k & 1) == 0 ? 1 : -1);
      orders.push_back(order);
    }
  } while (std::ranges::next_permutation(column).found);
  return orders;
}

double distance(const Eigen::MatrixXf& a, const Eigen::MatrixXf& b) {
  Eigen::MatrixXf squared = -2 * a * b.transpose();
  squared.colwise() += a.rowwise().squaredNorm();
  squared.rowwise() += b.rowwise().squaredNorm().transpose();
  return squared.rowwise().minCoeff().cwiseMax(0).cwiseSqrt().mean() +
         squared.colwise().minCoeff().cwiseMax(0).cwiseSqrt().mean();
}

}  // namespace

Eigen::MatrixXd SignedOrder::applied(const Eigen::MatrixXd& points) const {
  Eigen::MatrixXd result(points.rows(), points.cols());
  for (std::size_t k = 0; k < column.size(); ++k) result.col(k) = sign[k] * points.col(column[k]);
  return result;
}

SignedOrder best_signed_order(const Eigen::MatrixXd& source, const Eigen::MatrixXd& target,
                              const Context& context) {
  const std::vector<SignedOrder> orders = all_signed_orders(static_cast<int>(source.cols()));
  const Eigen::MatrixXf goal = target.cast<float>();
  std::vector<double> distances(orders.size());
  parallel_for(std::ssize(orders), context, [&](std::ptrdiff_t i) {
    distances[i] = distance(orders[i].applied(source).cast<float>(), goal);
  });
  return orders[std::ranges::min_element(distances) - distances.begin()];
}

}  // namespace isomatch::baselines
