// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "spectral/eigenbasis.h"

namespace isomatch::spectral {

/// Samples of the source of a map: rows of its basis, and the area that each stands for.
struct Samples {
  Eigen::MatrixXf functions;
  Eigen::VectorXf areas;
};

/// One step of ZoomOut (Melzi et al. 2019): from a map, a target vertex a sample, to a functional
/// map between the first `size` eigenfunctions and back. O(samples * N * size).
std::vector<int> refine(const Samples& source, const Eigenbasis& target,
                        const std::vector<int>& map, int size, const Context& context);

}  // namespace isomatch::spectral
