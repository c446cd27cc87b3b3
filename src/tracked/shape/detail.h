// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <vector>

#include "elastic/features.h"
#include "isomatch/context.h"
#include "isomatch/geodesics/geodesics.h"
#include "shape/prepared_shape.h"
#include "tracked/options.h"

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
  std::shared_ptr<const GeodesicGraph> graph;
};

/// `surface` is that of `shape`, or its mirror image, in any size. O(N log N).
Detail make_detail(const PreparedShape& shape, const Surface& surface,
                   const PyramidOptions& options, const Context& context);

/// The distances from these vertices of the detail, one for each place.
void set_places(Detail& detail, const std::vector<int>& vertices, const Context& context);

/// For each vertex of a surface a vertex of its detail that is close. O(N).
std::vector<int> anchors(const Surface& surface, const Detail& detail, const Context& context);

}  // namespace isomatch::tracked
