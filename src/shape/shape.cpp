// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/shape.h"

#include <cmath>
#include <utility>

namespace isomatch {
namespace {

/// Divides lengths by `unit`, areas by its square.
void rescale(Surface& surface, double unit) {
  for (Point& p : surface.mesh.vertices) p /= unit;
  surface.area /= unit * unit;
  surface.total_area /= unit * unit;
}

}  // namespace

Shape prepare_shape(const Mesh& input, const GeodesicOptions& options, const Context& context) {
  return prepare_shape(extract_surface(input), options, context);
}

Shape prepare_shape(Surface surface, const GeodesicOptions& options, const Context& context) {
  const double unit = std::exp2(std::round(std::log2(surface.area) / 2));
  rescale(surface, unit);
  GeodesicGraph graph(surface.mesh, options, context);
  std::vector<double> areas = vertex_areas(surface.mesh);
  const double max_geodesic = geodesic_diameter(graph, context);
  return {std::move(surface), unit, std::move(graph), std::move(areas), max_geodesic};
}

}  // namespace isomatch
