// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/shape.h"

namespace isomatch {

Shape prepare_shape(const Mesh& input, const GeodesicOptions& options, const Context& context) {
  return prepare_shape(extract_surface(input), options, context);
}

Shape prepare_shape(Surface surface, const GeodesicOptions& options, const Context& context) {
  GeodesicGraph graph(surface.mesh, options, context);
  std::vector<double> areas = vertex_areas(surface.mesh);
  const double max_geodesic = geodesic_diameter(graph, context);
  return {std::move(surface), std::move(graph), std::move(areas), max_geodesic};
}

}  // namespace isomatch
