// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <vector>

#include "isomatch/geodesics/geodesics.h"
#include "shape/surface.h"

namespace isomatch {

/// A surface of unit area with the distances along it. Cheap to copy.
class MetricSurface {
 public:
  MetricSurface(std::shared_ptr<const Surface> surface, std::shared_ptr<const GeodesicGraph> graph,
                double max_geodesic)
      : surface_(std::move(surface)), graph_(std::move(graph)), max_geodesic_(max_geodesic) {}

  const Surface& surface() const { return *surface_; }
  const Mesh& mesh() const { return surface_->mesh; }
  const std::vector<double>& vertex_areas() const { return surface_->vertex_areas; }
  const GeodesicGraph& graph() const { return *graph_; }
  int num_vertices() const { return surface_->num_vertices(); }
  /// The largest geodesic distance on the surface, which normalises g to [0, 1] in everything that
  /// follows the paper (Section 2). See `geodesic_diameter`.
  double max_geodesic() const { return max_geodesic_; }

 private:
  std::shared_ptr<const Surface> surface_;
  std::shared_ptr<const GeodesicGraph> graph_;
  double max_geodesic_;
};

}  // namespace isomatch
