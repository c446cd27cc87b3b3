// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "tracked/tracks/refinement.h"

namespace isomatch::tracked {

/// Lets the target do the last rounds as well, from the map of a finished track on, onto the
/// source. The track ends half way between both maps where they agree roughly: what a registration
/// does wrong depends on which of the shapes it bends, so the mean is closer to the truth.
/// The energy, distance and deviation of the track stay those by which it was judged.
void settle_with_reverse(Track& track, const Refinement& refinement, const Pyramid& target,
                         const Options& options, const Context& context = {});

}  // namespace isomatch::tracked
