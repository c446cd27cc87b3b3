// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "spectral/eigenbasis.h"

namespace isomatch::spectral {

/// Samples of the source of a map: rows of its basis, and the area that each stands for.
struct Samples {
  Eigen::MatrixXf functions;
  Eigen::VectorXf areas;
};

/// A map in both directions between samples and the vertices of the bases.
struct TwoWayMap {
  /// For each source sample a vertex of the target's basis, for each target sample a source sample.
  std::vector<int> forth, back;
};

/// One step of ZoomOut (Melzi et al. 2019), symmetric in the shapes: from a map of the samples
/// `source` and `target` to a functional map between the first `size` eigenfunctions, the mean of
/// those of both directions, and back to vertices of `basis`, one for each of the samples `wanted`
/// of the source. O(samples * N * size).
std::vector<int> refine(const Samples& source, const Samples& target, const Eigenbasis& basis,
                        const TwoWayMap& map, const Samples& wanted, int size,
                        const Context& context);

}  // namespace isomatch::spectral
