// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>

#include "isomatch/mesh.h"

namespace isomatch::baselines {

/// The orientation operator of Ren et al. 2018 in a basis: the matrix of g -> n . (v x grad g),
/// where v is the direction of the gradient of `function` on each face and n the face's normal. It
/// changes sign under a map that turns the surface over. `basis` has a function a column,
/// orthonormal with respect to area, a third of a face counting for each of its corners.
Eigen::MatrixXd orientation_operator(const Mesh& mesh, const Eigen::MatrixXd& basis,
                                     const Eigen::VectorXd& function);

}  // namespace isomatch::baselines
