// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>

#include "isomatch/context.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch::spectral {

/// The first eigenfunctions of the Laplace-Beltrami operator of a mesh (cotangent weights, lumped
/// mass), orthonormal with respect to area.
struct Eigenbasis {
  /// N x K, one eigenfunction a column. Their signs are arbitrary.
  Eigen::MatrixXf functions;
  /// Ascending, the first about zero; in units of 1 / area of the coordinates.
  Eigen::VectorXd values;
};

/// At most `count` eigenfunctions, fewer on meshes that are too small. Shift and invert with
/// Lanczos iterations; O(N log N + count^2 N). Throws `SolverFailure` if they do not converge.
Eigenbasis eigenbasis(const Mesh& mesh, int count, const Context& context = {});

}  // namespace isomatch::spectral
