// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "tracked/track.h"

namespace isomatch::tracked {

struct Finals {
  /// Those that are wanted, best first, all different.
  std::vector<Track> tracks;
  /// See `TrackedResult::confidence`.
  double confidence = 1;
};

/// Follows the best of `judged`. Those that end up as the same map count once.
Finals run_finals(const Model& target, const std::vector<Judged>& judged,
                  const TrackerOptions& options, const Context& context);

}  // namespace isomatch::tracked
