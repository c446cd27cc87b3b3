// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/prepared_shape.h"

#include <utility>

#include "isomatch/error.h"
#include "shape/inspection.h"

namespace isomatch {

PreparedShape::PreparedShape(Mesh mesh, const GeodesicOptions& geodesics)
    : mesh_(std::move(mesh)), geodesics_(geodesics) {
  geodesics.validate();
  Inspection inspection = inspect(mesh_);
  if (!inspection.surface) throw InvalidInput("the mesh has no face of positive area");
  diagnosis_ = inspection.diagnosis;
  surface_ = std::make_shared<const Surface>(unit_surface(std::move(*inspection.surface)));
}

std::shared_ptr<const GeodesicGraph> PreparedShape::graph(const GeodesicOptions& options,
                                                          const Context& context) const {
  return graphs_.get(options, [&] { return GeodesicGraph(surface_->mesh, options, context); });
}

MetricSurface PreparedShape::metric(const Context& context) const {
  auto graph = this->graph(geodesics_, context);
  const double longest =
      *max_geodesic_.get(true, [&] { return geodesic_diameter(*graph, context); });
  return {surface_, std::move(graph), longest};
}

}  // namespace isomatch
