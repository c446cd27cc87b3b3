// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/embedding.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

namespace isomatch::baselines {
namespace {

using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Affinities of the bases (rows) to all vertices (columns).
Eigen::MatrixXd affinities(const MetricSurface& shape, std::span<const int> bases,
                           const Context& context) {
  const std::vector<float> fields = geodesic_fields(shape.graph(), bases, context);
  const Eigen::MatrixXd g =
      Eigen::Map<const RowMajor>(fields.data(), std::ssize(bases), shape.num_vertices())
          .cast<double>();
  double sigma = 0;
  for (int base : bases) sigma = std::max(sigma, g.col(base).maxCoeff());
  return (-g.array().square() / (2 * sigma * sigma)).exp();
}

}  // namespace

Embedding embed(const MetricSurface& shape, std::span<const int> bases, int dimensions,
                const Context& context) {
  const Eigen::MatrixXd all = affinities(shape, bases, context);
  const Eigen::MatrixXd half = all(Eigen::all, std::vector<int>(bases.begin(), bases.end()));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((half + half.transpose()) / 2);
  const Eigen::Index count = std::min<Eigen::Index>(dimensions, std::ssize(bases) - 1);
  // Ascending order: the last one is left out.
  const auto chosen = Eigen::seqN(std::ssize(bases) - 2, count, Eigen::fix<-1>);
  const Eigen::VectorXd roots = solver.eigenvalues()(chosen).cwiseMax(1e-12).cwiseSqrt();
  const Eigen::MatrixXd vectors = solver.eigenvectors()(Eigen::all, chosen);
  return {vectors * roots.asDiagonal(),
          all.transpose() * vectors * roots.cwiseInverse().asDiagonal()};
}

}  // namespace isomatch::baselines
