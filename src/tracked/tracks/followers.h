// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/surface_map.h"
#include "shape/surface.h"

namespace isomatch::tracked {

/// Gives vertices of faces that are not part of the source's surface, since they belong to other
/// components, the closest points of the target, if these are at most as far as `reach`. `moved`
/// are the source's vertices after registration, which such vertices follow, and `reach` is in the
/// same units, those of the target's mesh. `map` is in the caller's numbers. O(N log N).
void match_followers(const Mesh& source, const Surface& source_surface,
                     const Surface& target_surface, const std::vector<Point>& moved, double reach,
                     SurfaceMap& map);

}  // namespace isomatch::tracked
