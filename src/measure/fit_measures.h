// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/measure/fit.h"
#include "shape/numbers.h"

namespace isomatch {

/// Of a map to vertices; `scale` as in `FitOptions`. O(N log N).
FitMeasures measure_fit(const Shape& source, const Shape& target, const OnSurface<VertexMap>& map,
                        double scale, const Context& context);

}  // namespace isomatch
