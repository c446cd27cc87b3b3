// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "shape/metric_surface.h"
#include "shape/numbers.h"

namespace isomatch {

/// At most `count` of `matches`, evenly spaced over the source: all if there are no more than
/// `count`; otherwise those of source vertices in farthest point order, of each vertex the match
/// with the lowest target.
std::vector<Match> evenly_spaced_matches(const MetricSurface& source, const SurfaceMatches& matches,
                                         int count);

}  // namespace isomatch
