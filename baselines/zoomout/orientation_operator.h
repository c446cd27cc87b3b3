// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>

#include "isomatch/mesh/mesh.h"

namespace isomatch::baselines {

/// The orientation operator of Ren et al. 2018 in a basis: the matrix of g -> n . (grad f x grad g)
/// with f = `function` and n the normal of each face. It changes sign under a map that turns the
/// surface over. `basis` has a function a column, orthonormal with respect to area, a third of a
/// face counting for each of its corners. Gradients keep their length: on 20 pairs of faust5k the
/// maps were better than with unit gradients, as in the authors' code, which are noise where f is
/// flat.
Eigen::MatrixXd orientation_operator(const Mesh& mesh, const Eigen::MatrixXd& basis,
                                     const Eigen::VectorXd& function);

}  // namespace isomatch::baselines
