// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/transfer.h"

#include <algorithm>
#include <cmath>

namespace isomatch::tracked {

DeformedSurface transfer(const Shape& shape, const UnitSurface& surface, const Proxy& proxy,
                         const elastic::Deformation& deformation,
                         const std::vector<elastic::Features>& node_features) {
  std::vector<int> sources(deformation.size());
  for (std::size_t i = 0; i < sources.size(); ++i)
    sources[i] = proxy.surface_vertex[proxy.nodes[i]];
  const std::vector<int> nearest = GeodesicSearch(shape.graph).nearest_source(sources).nearest;
  DeformedSurface result{std::vector<Point>(nearest.size()), std::vector<Point>(nearest.size()),
                         surface.features};
  for (std::size_t v = 0; v < nearest.size(); ++v) {
    const Point& p = surface.mesh.vertices[v];
    std::vector<int> nodes{nearest[v]};
    for (int j : deformation.neighbours()[nearest[v]]) nodes.push_back(j);
    double reach = 0;
    for (int j : nodes) reach = std::max(reach, (p - deformation.rest()[j]).norm());
    double total = 0;
    Point position(0, 0, 0), normal(0, 0, 0);
    auto& place = result.features[v].place;
    place.fill(0);
    for (int j : nodes) {
      const Point offset = p - deformation.rest()[j];
      const double share = 1 - offset.norm() / (1.01 * reach + 1e-12);
      const double weight = share * share;
      total += weight;
      for (int k = 0; k < elastic::kPlaces; ++k) place[k] += weight * node_features[j].place[k];
      position += weight * (deformation.rotations()[j] * offset + deformation.positions()[j]);
      normal += weight * (deformation.rotations()[j] * surface.normals[v]);
    }
    for (double& distance : place) distance /= total;
    result.positions[v] = position / total;
    result.normals[v] = normal.normalized();
  }
  return result;
}

}  // namespace isomatch::tracked
