// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/surface_map.h"
#include "tracked/options.h"
#include "tracked/shape/proxy.h"

namespace isomatch::tracked {

/// Slides the images of a proxy's vertices along another until both surfaces curve alike there:
/// Gauss-Newton steps that lessen what the second fundamental forms differ by, the bending energy
/// of a thin shell (Windheuser et al. 2011, Ezuz et al. 2019), as smooth vector fields. Closest
/// points leave free what only detail can tell. Vertices that are not `inside` (all if it is empty)
/// follow the others. Both proxies must be oriented. O(N) a step.
SurfaceMap slid(const Proxy& source, const Proxy& target, SurfaceMap images,
                const std::vector<bool>& inside, const SlidingOptions& options);

}  // namespace isomatch::tracked
