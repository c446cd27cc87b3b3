// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "zoomout/functional_map.h"

#include <Eigen/Cholesky>
#include <unsupported/Eigen/KroneckerProduct>

#include "zoomout/orientation_operator.h"

namespace isomatch::baselines {
namespace {

using Eigen::kroneckerProduct;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The energy c^T H c / 2 - r^T c of the entries c of a map, column by column.
struct Quadratic {
  MatrixXd matrix;
  VectorXd right;

  double operator()(const VectorXd& c) const { return c.dot(matrix * c) / 2 - right.dot(c); }
};

/// Adds the sum of |C A - B C|^2 / 2 over pairs of operators, times `weight`.
void add_commutativity(const std::vector<MatrixXd>& from, const std::vector<MatrixXd>& to,
                       double weight, MatrixXd& matrix) {
  if (from.empty()) return;
  const Eigen::Index n = from[0].rows(), m = to[0].rows();
  MatrixXd of_from = MatrixXd::Zero(n, n), of_to = MatrixXd::Zero(m, m);
  for (std::size_t i = 0; i < from.size(); ++i) {
    of_from += from[i] * from[i].transpose();
    of_to += to[i].transpose() * to[i];
    const MatrixXd mixed = kroneckerProduct(from[i], to[i]);
    matrix -= weight * (mixed + mixed.transpose());
  }
  matrix += weight * MatrixXd(kroneckerProduct(of_from, MatrixXd::Identity(m, m)));
  matrix += weight * MatrixXd(kroneckerProduct(MatrixXd::Identity(n, n), of_to));
}

/// Penalises entries between eigenfunctions of different frequency.
VectorXd laplacian_penalty(const DescribedBasis& from, const DescribedBasis& to) {
  const VectorXd a = from.values / from.values.sum(), b = to.values / to.values.sum();
  MatrixXd penalty = (b.replicate(1, a.size()) - a.transpose().replicate(b.size(), 1)).cwiseAbs2();
  penalty /= penalty.squaredNorm();
  return penalty.reshaped();
}

Quadratic without_orientation(const DescribedBasis& from, const DescribedBasis& to,
                              const FunctionalMapWeights& weights) {
  const Eigen::Index n = from.values.size(), m = to.values.size();
  Quadratic energy{MatrixXd::Zero(n * m, n * m), VectorXd::Zero(n * m)};
  add_commutativity(from.multiplications, to.multiplications, weights.multiplications,
                    energy.matrix);
  const MatrixXd square = from.descriptors * from.descriptors.transpose();
  energy.matrix +=
      weights.descriptors * MatrixXd(kroneckerProduct(square, MatrixXd::Identity(m, m)));
  energy.right =
      weights.descriptors * MatrixXd(to.descriptors * from.descriptors.transpose()).reshaped();
  energy.matrix.diagonal() += weights.laplacian * laplacian_penalty(from, to);
  return energy;
}

/// The minimum among maps whose first column is `first`.
VectorXd minimum(const Quadratic& energy, const VectorXd& first) {
  const Eigen::Index fixed = first.size(), free = energy.right.size() - fixed;
  const VectorXd right =
      energy.right.tail(free) - energy.matrix.bottomLeftCorner(free, fixed) * first;
  VectorXd c(energy.right.size());
  c << first, energy.matrix.bottomRightCorner(free, free).ldlt().solve(right);
  return c;
}

}  // namespace

DescribedBasis describe(const Mesh& mesh, const VectorXd& areas, const MatrixXd& functions,
                        const VectorXd& values, const MatrixXd& descriptors) {
  DescribedBasis result{values, functions(0, 0) < 0 ? -1.0 : 1.0, {}, {}, {}};
  const MatrixXd dual = functions.transpose() * areas.asDiagonal();
  MatrixXd normalised = descriptors;
  for (Eigen::Index d = 0; d < descriptors.cols(); ++d) {
    auto column = normalised.col(d);
    column /= std::sqrt(areas.dot(column.cwiseAbs2()));
    result.multiplications.push_back(dual * column.asDiagonal() * functions);
    result.orientations.push_back(orientation_operator(mesh, functions, column));
  }
  result.descriptors = dual * normalised;
  return result;
}

MatrixXd fit_functional_map(const DescribedBasis& from, const DescribedBasis& to,
                            const FunctionalMapWeights& weights) {
  const Eigen::Index n = from.values.size(), m = to.values.size();
  VectorXd first = VectorXd::Zero(m);
  first[0] = from.constant * to.constant;
  Quadratic energy = without_orientation(from, to, weights);
  const VectorXd start = minimum(energy, first);
  Quadratic orientation{MatrixXd::Zero(n * m, n * m), VectorXd::Zero(n * m)};
  add_commutativity(from.orientations, to.orientations, 1, orientation.matrix);
  const double unoriented = energy(start) + weights.descriptors * to.descriptors.squaredNorm() / 2;
  const double scale = orientation(start);
  if (scale > 0) energy.matrix += weights.orientation * unoriented / scale * orientation.matrix;
  return minimum(energy, first).reshaped(m, n);
}

}  // namespace isomatch::baselines
