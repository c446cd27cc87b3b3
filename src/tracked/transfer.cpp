// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/transfer.h"

#include <algorithm>
#include <cmath>

namespace isomatch::tracked {
namespace {

/// The node that is closest along the surface, for each vertex of the detail.
std::vector<int> nearest_nodes(const Model& model, int nodes) {
  std::vector<int> sources(nodes);
  for (int i = 0; i < nodes; ++i) sources[i] = model.proxy.detail_vertex[model.proxy.nodes[i]];
  return GeodesicSearch(model.detail.graph).nearest_source(sources).nearest;
}

/// Means over a node and those around it, by their distances at rest from a point.
class Blend {
 public:
  Blend(const elastic::Deformation& deformation, const std::vector<elastic::Features>& features)
      : deformation_(deformation), features_(features) {
    for (const auto& rotation : deformation.rotations())
      rotations_.push_back(rotation.toRotationMatrix());
  }

  /// Moves a point along with the nodes.
  void move(int nearest, Point& position, Point& normal) const {
    Point moved(0, 0, 0), turned(0, 0, 0);
    for_each_weight(nearest, position, [&](int node, double weight) {
      const Point offset = position - deformation_.rest()[node];
      moved += weight * (rotations_[node] * offset + deformation_.positions()[node]);
      turned += weight * (rotations_[node] * normal);
    });
    position = moved;
    normal = turned.normalized();
  }

  std::array<double, elastic::kPlaces> place(int nearest, const Point& position) const {
    std::array<double, elastic::kPlaces> mean{};
    for_each_weight(nearest, position, [&](int node, double weight) {
      for (int k = 0; k < elastic::kPlaces; ++k) mean[k] += weight * features_[node].place[k];
    });
    return mean;
  }

 private:
  template <class Visit>
  void for_each_weight(int nearest, const Point& position, const Visit& visit) const {
    const auto distance = [&](int node) { return (position - deformation_.rest()[node]).norm(); };
    const auto neighbours = deformation_.neighbours()[nearest];
    double reach = distance(nearest);
    for (int j : neighbours) reach = std::max(reach, distance(j));
    reach = 1.01 * reach + 1e-12;
    const auto weight = [&](int node) { return std::pow(1 - distance(node) / reach, 2); };
    double total = weight(nearest);
    for (int j : neighbours) total += weight(j);
    visit(nearest, weight(nearest) / total);
    for (int j : neighbours) visit(j, weight(j) / total);
  }

  const elastic::Deformation& deformation_;
  const std::vector<elastic::Features>& features_;
  std::vector<Eigen::Matrix3d> rotations_;
};

}  // namespace

DeformedSurface transfer(const Model& model, const elastic::Deformation& deformation,
                         const std::vector<elastic::Features>& node_features,
                         const Context& context) {
  const std::vector<int> nearest = nearest_nodes(model, deformation.size());
  const Blend blend(deformation, node_features);
  DeformedSurface result{model.surface.mesh.vertices, model.surface.normals, model.detail.features};
  for (std::size_t d = 0; d < nearest.size(); ++d)
    result.features[d].place = blend.place(nearest[d], model.detail.mesh.vertices[d]);
#pragma omp parallel for schedule(static) num_threads(context.threads)
  for (std::size_t v = 0; v < result.positions.size(); ++v)
    blend.move(nearest[model.anchors[v]], result.positions[v], result.normals[v]);
  return result;
}

}  // namespace isomatch::tracked
