// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "elastic/projection.h"
#include "tracked/tracks/refinement.h"

namespace isomatch::tracked {

/// A hand or a foot can be half a turn off: it is nearly symmetric, and the twist of its limb costs
/// little. Turns the end of the limb for which that fits best, registered alone, and gives the
/// vertices of the target's proxy at which the nodes of the track are then; none where every end
/// fits clearly better as it is. O(measured nodes * N).
std::vector<int> with_an_end_turned(const Track& track, const Proxy& target,
                                    const elastic::Projection& surface, const Options& options);

}  // namespace isomatch::tracked
