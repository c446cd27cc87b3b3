// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/surface_map.h"
#include "shape/surface.h"
#include "tracked/options.h"

namespace isomatch::tracked {

/// What a registered surface is to stay near to, both ways.
struct Images {
  const SurfaceMap& source_to_target;
  const SurfaceMap& target_to_source;
};

/// `positions` of the vertices of `source`, which lie near `target`, where triangles that became
/// folded or squeezed are smoothed: around them the gradient of the deformation is interpolated
/// from what surrounds them, and the surface integrated anew (Sumner and Popovic 2004, Yu et al.
/// 2004). That is done where it mends more than it moves the surface off its images, so that some
/// such triangles may remain. Vertices `kept`, and all of a surface without such triangles, stay
/// where they are. Where a patch is small all of its gradients are averaged instead. Deterministic.
/// O(N log N).
std::vector<Point> unfolded(const Surface& source, std::vector<Point> positions,
                            const Surface& target, const Images& images,
                            const std::vector<int>& kept, const UnfoldingOptions& options,
                            const Context& context);

}  // namespace isomatch::tracked
