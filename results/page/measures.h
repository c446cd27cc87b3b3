// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/context.h"
#include "results/evaluation.h"
#include "results/page/shown_match.h"

namespace isomatch::results {

/// How good a map is at each vertex of the source's file; NaN where it was not measured.
struct MapMeasures {
  /// Isometric distortion, over the largest geodesic distances.
  std::vector<double> d_iso;
  /// Geodesic distance from the true place over sqrt(area of the target). Empty without a truth.
  std::vector<double> error;
};

/// Vertices at which errors are measured at most; others have the error of the nearest of these.
inline constexpr int kMaxErrorSamples = 20000;

/// Measures every map of `match`, against `truth` if it is given (but for its symmetric one). The
/// paper's d_iso is that of its last level, others are measured against 100 matches as in the
/// paper. Throws `BadFile` as `read_ground_truth`, and `InvalidInput` if only one file of a truth
/// is given.
std::vector<MapMeasures> measure_maps(const ShownMatch& match, const TruthFiles& truth,
                                      const Context& context);

}  // namespace isomatch::results
