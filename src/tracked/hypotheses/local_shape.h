// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "tracked/options.h"
#include "tracked/shape/proxy.h"

namespace isomatch::tracked {

/// What a surface looks like around nodes from which distances are measured, one row each:
/// histograms of height above the tangent plane and of the angle between normals in rings of
/// geodesic distance, in the manner of spin images (Johnson and Hebert 1999). They hardly change
/// with the pose, and where the surface ends nearby little, as each ring is normalised.
/// O(nodes * vertices).
FloatMatrix local_shapes(const Proxy& proxy, const std::vector<int>& nodes,
                         const LocalShapeOptions& options);

}  // namespace isomatch::tracked
