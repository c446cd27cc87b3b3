// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::baselines {

/// A truncated Laplace-Beltrami basis of one shape of unit area, with what a functional map should
/// respect.
struct DescribedBasis {
  /// k eigenvalues.
  Eigen::VectorXd values;
  /// The constant value of the first eigenfunction, 1 or -1.
  double constant = 1;
  /// Coefficients of the descriptors, k x p.
  Eigen::MatrixXd descriptors;
  /// For each descriptor the operators that multiply by it, and its orientation operator; k x k.
  std::vector<Eigen::MatrixXd> multiplications, orientations;
};

/// Of `functions` (N x k, orthonormal with respect to `areas`, which sum to 1) on `mesh`, with
/// `descriptors` (N x p), which are normalised.
DescribedBasis describe(const Mesh& mesh, const Eigen::VectorXd& areas,
                        const Eigen::MatrixXd& functions, const Eigen::VectorXd& values,
                        const Eigen::MatrixXd& descriptors);

/// Weights of the terms of the functional map. On 20 pairs of faust5k these left one map wrong
/// after ZoomOut, the weights of the authors' code (0.1, 1, 0.1, 0.1) eight to eleven.
struct FunctionalMapWeights {
  double descriptors = 1;
  double multiplications = 0.1;
  double laplacian = 1;
  /// Relative to the other terms' energy over that of the orientation term, at their minimum.
  double orientation = 1;
};

/// The functional map C (k_to x k_from) of Ren et al. 2018 that takes coefficients of `from` to
/// those of `to`: least squares over the preservation of descriptors and commutativity with
/// multiplications by them, with the Laplacian and with the orientation operators. Constants go to
/// constants. One dense system of k_from k_to unknowns.
Eigen::MatrixXd fit_functional_map(const DescribedBasis& from, const DescribedBasis& to,
                                   const FunctionalMapWeights& weights);

}  // namespace isomatch::baselines
