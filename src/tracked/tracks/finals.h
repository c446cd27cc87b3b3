// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "tracked/tracks/refinement.h"

namespace isomatch::tracked {

struct Finals {
  /// Those that are wanted, best first, all different.
  std::vector<Track> tracks;
  /// See `Refinement::nearest_nodes`, of the first of them.
  std::vector<int> nearest;
  /// See `TrackedResult::ambiguity`.
  double ambiguity = 0;
  /// The least cost on the middle level.
  double middle_cost = 0;
};

/// Follows the best of `judged`. Those that end up as the same map count once.
Finals run_finals(const Pyramid& target, const std::vector<Judged>& judged, const Options& options,
                  const Context& context);

/// Those of the landmarks that one of `contradicting` does not satisfy although it fits far better
/// than `middle_cost`: of such hypotheses the one that contradicts the fewest counts.
SurfaceMatches contradicted_landmarks(const Pyramid& target,
                                      const std::vector<Judged>& contradicting, double middle_cost,
                                      Options options, const Context& context);

}  // namespace isomatch::tracked
