// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/methods/tracked.h"
#include "tracked/options.h"

namespace isomatch::tracked {

/// What the public options mean, but for the landmarks.
Options options_of(const TrackedOptions& options);

/// `match_tracked` with every number of the method in `options`, for measuring what they do.
TrackedResult match(const Shape& source, const Shape& target, const TrackedOptions& tracked_options,
                    Options options, const Context& context);

/// The map of a pair of which it is known where vertices of the source's surface lie on that of the
/// target, both in the numbers and units of the surfaces: nodes begin there, settle as a
/// registration does at last, and carry all vertices along. O(N log N).
TrackedMap settled(const Shape& source, const Shape& target, const SurfaceMap& places,
                   const TrackedOptions& tracked_options, const Context& context);

}  // namespace isomatch::tracked
