// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <span>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/topology.h"
#include "spectral/eigenbasis.h"

namespace isomatch::spectral {

/// Samples of the source of a map: rows of its basis, and the area that each stands for.
struct Samples {
  Eigen::MatrixXf functions;
  Eigen::VectorXf areas;
};

/// A target mesh with its eigenfunctions.
struct SpectralTarget {
  const Mesh& mesh;
  const IndexLists& vertex_faces;
  const Eigenbasis& basis;
};

/// Sizes of the bases, in order.
struct SpectralOptions {
  int first = 20, last = 100, step = 20;
};

/// ZoomOut (Melzi et al. 2019): from a map (a target vertex a sample) to a functional map and back,
/// with more and more eigenfunctions. O(samples * N * last) a step.
std::vector<int> refine(const Samples& source, const SpectralTarget& target, std::vector<int> map,
                        const SpectralOptions& options, const Context& context);

}  // namespace isomatch::spectral
