// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/SparseCore>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// Angle of `face` at `corner`, in radians.
double corner_angle(const Mesh& mesh, const Face& face, int corner);

/// Half the cotangent of that angle, the weight of the edge opposite, held to [0, 10].
double cotangent_weight(const Mesh& mesh, const Face& face, int corner);

/// Cotangent Laplacian (N x N, positive semi-definite, without the mass matrix). Weights are held
/// to [0, 10], an angle of about 6 degrees, so that slivers neither couple their ends rigidly nor
/// repel them.
Eigen::SparseMatrix<double, Eigen::RowMajor> cotangent_laplacian(const Mesh& mesh);

}  // namespace isomatch
