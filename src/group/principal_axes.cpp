// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "group/principal_axes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "isomatch/error.h"

namespace isomatch {
namespace {

/// Eigenvalues from the smallest, and their vectors.
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen_of(const Eigen::MatrixXd& lower) {
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(lower);
  if (solver.info() != Eigen::Success)
    throw SolverFailure("the principal modes of the shapes cannot be found");
  return solver;
}

/// How many of the largest count.
Eigen::Index num_axes(const Eigen::VectorXd& ascending, double least) {
  constexpr double kSmallestShare = 1e-10;
  const Eigen::Index size = ascending.size();
  const double threshold = std::max(least, kSmallestShare * ascending[size - 1]);
  Eigen::Index count = 0;
  while (count < size && ascending[size - 1 - count] > threshold) ++count;
  return count;
}

}  // namespace

ShapeRows deviations_from(const Eigen::RowVectorXd& mean, const ShapeRows& rows) {
  return rows.rowwise() - mean;
}

PrincipalAxes principal_axes(const ShapeRows& deviations, double least) {
  const Eigen::Index num_shapes = deviations.rows(), size = deviations.cols();
  // Products of shapes have the same eigenvalues as those of coordinates.
  const bool is_dual = num_shapes <= size;
  Eigen::MatrixXd products =
      Eigen::MatrixXd::Zero(std::min(num_shapes, size), std::min(num_shapes, size));
  const auto weight = 1 / static_cast<double>(num_shapes - 1);
  if (is_dual)
    products.selfadjointView<Eigen::Lower>().rankUpdate(deviations, weight);
  else
    products.selfadjointView<Eigen::Lower>().rankUpdate(deviations.transpose(), weight);
  const auto solver = eigen_of(products);
  const Eigen::Index count = num_axes(solver.eigenvalues(), least);
  const Eigen::MatrixXd vectors = solver.eigenvectors().rightCols(count).rowwise().reverse();
  PrincipalAxes axes{solver.eigenvalues().tail(count).reverse(), {}};
  if (is_dual)
    axes.scores = vectors * (axes.variances / weight).cwiseSqrt().asDiagonal();
  else
    axes.scores = deviations * vectors;
  return axes;
}

Eigen::MatrixXd axis_directions(const ShapeRows& deviations, const PrincipalAxes& axes,
                                Eigen::Index count) {
  const auto factor = static_cast<double>(deviations.rows() - 1);
  const Eigen::VectorXd squares = factor * axes.variances.head(count);
  return squares.cwiseInverse().asDiagonal() *
         (axes.scores.leftCols(count).transpose() * deviations);
}

}  // namespace isomatch
