// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/measure/fit.h"

namespace isomatch {

/// Throws `InvalidInput` if the map does not fit the surfaces. O(N log N).
FitMeasures measure_fit(const Shape& source, const Shape& target, const SurfaceMap& map,
                        const Context& context);

}  // namespace isomatch
