// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "elastic/features.h"
#include "isomatch/context.h"
#include "isomatch/geodesics/geodesics.h"
#include "tracked/unit_surface.h"

namespace isomatch::tracked {

/// A copy of a surface that is simplified if it has many vertices, so that what must be solved or
/// searched on a fine mesh costs no more than on one of so many.
struct Detail {
  Mesh mesh;
  /// Vertices of the surface, ascending.
  std::vector<int> surface_vertex;
  IndexLists faces;
  /// Of the vertices; places are filled in by `set_places`.
  std::vector<elastic::Features> features;
  GeodesicGraph graph;
};

/// O(N log N).
Detail make_detail(const UnitSurface& surface, int vertices, const Context& context);

/// The distances from these vertices of the detail, one for each place.
void set_places(Detail& detail, const std::vector<int>& vertices, const Context& context);

/// For each vertex of a surface a vertex of its detail that is close. O(N).
std::vector<int> anchors(const UnitSurface& surface, const Detail& detail, const Context& context);

}  // namespace isomatch::tracked
