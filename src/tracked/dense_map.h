// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/methods/tracked.h"
#include "tracked/track.h"

namespace isomatch::tracked {

/// Carries a track over to all vertices of both surfaces. O(N log N).
TrackedMap dense_map(const Track& track, const Model& target, const TrackerOptions& options,
                     const Context& context);

}  // namespace isomatch::tracked
