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

/// Moves points along with a node and the nodes around it, by their distances at rest.
class Blend {
 public:
  Blend(const elastic::Deformation& deformation, const std::vector<elastic::Features>& features)
      : deformation_(deformation), features_(features) {
    for (const auto& rotation : deformation.rotations())
      rotations_.push_back(rotation.toRotationMatrix());
  }

  void move(int nearest, Point& position, Point& normal, elastic::Features& features) const {
    const double reach = 1.01 * reach_of(nearest, position) + 1e-12;
    Sum sum;
    add(nearest, position, normal, reach, sum);
    for (int j : deformation_.neighbours()[nearest]) add(j, position, normal, reach, sum);
    position = sum.position / sum.weight;
    normal = sum.normal.normalized();
    for (int k = 0; k < elastic::kPlaces; ++k) features.place[k] = sum.place[k] / sum.weight;
  }

 private:
  struct Sum {
    double weight = 0;
    Point position{0, 0, 0}, normal{0, 0, 0};
    std::array<double, elastic::kPlaces> place{};
  };

  double reach_of(int nearest, const Point& p) const {
    double reach = (p - deformation_.rest()[nearest]).norm();
    for (int j : deformation_.neighbours()[nearest])
      reach = std::max(reach, (p - deformation_.rest()[j]).norm());
    return reach;
  }

  void add(int node, const Point& position, const Point& normal, double reach, Sum& sum) const {
    const Point offset = position - deformation_.rest()[node];
    const double share = 1 - offset.norm() / reach;
    const double weight = share * share;
    sum.weight += weight;
    for (int k = 0; k < elastic::kPlaces; ++k) sum.place[k] += weight * features_[node].place[k];
    sum.position += weight * (rotations_[node] * offset + deformation_.positions()[node]);
    sum.normal += weight * (rotations_[node] * normal);
  }

  const elastic::Deformation& deformation_;
  const std::vector<elastic::Features>& features_;
  std::vector<Eigen::Matrix3d> rotations_;
};

}  // namespace

elastic::Cloud transfer(const Model& model, const elastic::Deformation& deformation,
                        const std::vector<elastic::Features>& node_features,
                        const Context& context) {
  const std::vector<int> nearest = nearest_nodes(model, deformation.size());
  const Blend blend(deformation, node_features);
  elastic::Cloud cloud{model.surface.mesh.vertices, model.surface.normals,
                       model.attachment.features};
#pragma omp parallel for schedule(static) num_threads(context.threads)
  for (int v = 0; v < cloud.size(); ++v)
    blend.move(nearest[model.attachment.anchors[v]], cloud.positions[v], cloud.normals[v],
               cloud.features[v]);
  return cloud;
}

}  // namespace isomatch::tracked
