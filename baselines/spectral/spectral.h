// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/methods/paper.h"
#include "shape/metric_surface.h"

namespace isomatch::baselines {

struct SpectralOptions {
  /// Eigenvectors; the authors use 5 or 6.
  int dimensions = 5;
  /// Rounds of non-rigid ICP, over which the splines' smoothing falls geometrically.
  int rounds = 20;
  double first_smoothing = 1, last_smoothing = 0.01;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

struct SpectralResult {
  /// For each source base the place of its target base: the method as published, many-to-one.
  std::vector<int> base_matches;
  /// For each source vertex the target vertex that is nearest in the aligned embeddings.
  VertexMap source_to_target;
};

/// The spectral method of Jain and Zhang 2006: both shapes embedded by their geodesic affinities,
/// eigenvectors matched by a search over signs and orders, embeddings aligned by non-rigid ICP with
/// thin-plate splines, nearest neighbours. Vertices besides `bases` are embedded by the Nystroem
/// extension of Jain, Zhang and van Kaick 2007. Cannot tell a shape from its mirror image. Throws
/// `InvalidInput` if an option is out of range or a shape has not more bases than dimensions.
SpectralResult match_spectral(const MetricSurface& source, const MetricSurface& target,
                              const JointSampling& bases, const SpectralOptions& options = {},
                              const Context& context = {});

}  // namespace isomatch::baselines
