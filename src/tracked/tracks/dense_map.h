// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "shape/numbers.h"
#include "tracked/tracks/refinement.h"

namespace isomatch::tracked {

/// A map between all vertices of two surfaces.
struct DenseMap {
  SurfacePoints source_to_target, target_to_source;
  /// Of the vertices of both surfaces, 0 where they have no counterpart.
  std::vector<float> source_confidence, target_confidence;
  /// The source's vertices after registration, and after folds were smoothed.
  std::vector<Point> registered, unfolded;
};

/// Carries a track over to all vertices of both surfaces. O(N log N).
DenseMap dense_map(const Track& track, const Pyramid& target, const Options& options,
                   const Context& context);

}  // namespace isomatch::tracked
