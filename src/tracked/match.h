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

}  // namespace isomatch::tracked
