// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/geodesics/geodesics.h"
#include "isomatch/mesh/surface.h"

namespace isomatch {

/// A surface with what every stage of matching needs to know about it. Vertices are the surface's.
/// Lengths and areas are those of the input over `unit` and its square, so that 32-bit distances
/// hold whatever the input was measured in.
struct Shape {
  Surface surface;
  /// Length in the input of what is 1 long here: the power of two next to sqrt(area), so that no
  /// digit is lost.
  double unit = 1;
  GeodesicGraph graph;
  /// A third of the area of the faces around each vertex; their sum is `surface.area`.
  std::vector<double> vertex_areas;
  /// The largest geodesic distance on the surface, which normalises g to [0, 1] in everything that
  /// follows the paper (Section 2). See `geodesic_diameter`.
  double max_geodesic = 0;

  int num_vertices() const { return surface.num_vertices(); }
};

/// Extracts the surface of `input`, builds its geodesic graph and measures it. Throws
/// `InvalidInput` as `extract_surface` does. O(N log N).
Shape prepare_shape(const Mesh& input, const GeodesicOptions& options = {},
                    const Context& context = {});

/// Likewise of a surface that is extracted already.
Shape prepare_shape(Surface surface, const GeodesicOptions& options = {},
                    const Context& context = {});

}  // namespace isomatch
