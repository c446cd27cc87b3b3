// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/surface_map.h"
#include "shape/surface.h"

namespace isomatch::group {

/// For each vertex of a shape where it lies on the template, whose vertices are registered to it at
/// `registered`, in the coordinates of its surface, and lie on it at `places`: the closest point of
/// those of its faces all of whose corners have a place. None where a vertex is farther from them
/// than maps err and the closest point is at their rim. O(N log N).
SurfaceMap map_to_template(const Surface& template_surface, const Surface& shape,
                           const std::vector<Point>& registered, const SurfaceMap& places,
                           const Context& context);

}  // namespace isomatch::group
