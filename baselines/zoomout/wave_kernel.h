// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>

namespace isomatch::baselines {

/// Wave kernel signatures (Aubry et al. 2011) of all vertices, one energy a column: the share of
/// each squared eigenfunction (columns of `functions`) under a Gaussian about the energy, on the
/// logarithm of the eigenvalues. The first eigenfunction, the constant, is left out. `values` are
/// ascending.
Eigen::MatrixXd wave_kernel_signatures(const Eigen::MatrixXd& functions,
                                       const Eigen::VectorXd& values, int energies);

}  // namespace isomatch::baselines
