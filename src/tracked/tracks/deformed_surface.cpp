// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/deformed_surface.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "parallel.h"

namespace isomatch::tracked {
namespace {

/// The nodes that are at most two edges away from one, itself among them, ascending.
std::vector<int> within_two_edges(const IndexLists& neighbours, int node) {
  std::vector<int> around{node};
  for (int i : neighbours[node]) {
    around.push_back(i);
    around.insert(around.end(), neighbours[i].begin(), neighbours[i].end());
  }
  std::ranges::sort(around);
  around.erase(std::ranges::unique(around).begin(), around.end());
  return around;
}

/// Means over a node and those around it, by their distances at rest from a point.
class Blend {
 public:
  Blend(const elastic::Deformation& deformation, const elastic::PointCloud& nodes)
      : deformation_(deformation), nodes_(nodes), energies_(deformation.energies()) {
    for (const auto& rotation : deformation.rotations())
      rotations_.push_back(rotation.toRotationMatrix());
    for (int i = 0; i < deformation.size(); ++i)
      around_.push_back(within_two_edges(deformation.neighbours(), i));
  }

  /// What becomes of a point, and of the nodes around it.
  struct Moved {
    Point position{0, 0, 0}, normal{0, 0, 0};
    double inside = 0, strain = 0;
  };

  Moved move(int nearest, const Point& position, const Point& normal) const {
    Moved moved;
    for (const auto& [node, weight] : shares(nearest, position)) {
      const Point offset = position - deformation_.rest()[node];
      moved.position += weight * (rotations_[node] * offset + deformation_.positions()[node]);
      moved.normal += weight * (rotations_[node] * normal);
      if (nodes_.is_inside(node)) moved.inside += weight;
      moved.strain += weight * energies_[node] / nodes_.areas[node];
    }
    moved.normal.normalize();
    return moved;
  }

  std::array<double, elastic::kPlaces> place(int nearest, const Point& position) const {
    std::array<double, elastic::kPlaces> mean{};
    for (const auto& [node, weight] : shares(nearest, position))
      for (int k = 0; k < elastic::kPlaces; ++k) mean[k] += weight * nodes_.features[node].place[k];
    return mean;
  }

 private:
  struct Share {
    int node;
    double weight;
  };
  /// Of the nodes closest to a point, among those around the nearest; the weights have sum 1, and
  /// fall to zero at the first that has none, so that they change smoothly where others are
  /// closest.
  std::vector<Share> shares(int nearest, const Point& position) const {
    constexpr std::size_t kClosest = 8;  // A node, the ring around it, and the one that ends it.
    std::vector<Share> shares;
    for (int node : around_[nearest])
      shares.push_back({node, (position - deformation_.rest()[node]).norm()});
    const std::size_t count = std::min(kClosest, shares.size());
    std::ranges::partial_sort(shares, shares.begin() + static_cast<std::ptrdiff_t>(count), {},
                              &Share::weight);
    shares.resize(count);
    const double reach = (1 + 1e-9) * shares.back().weight + 1e-12;
    double total = 0;
    for (Share& share : shares) total += share.weight = std::pow(1 - share.weight / reach, 2);
    for (Share& share : shares) share.weight /= total;
    return shares;
  }

  const elastic::Deformation& deformation_;
  const elastic::PointCloud& nodes_;
  std::vector<double> energies_;
  std::vector<Eigen::Matrix3d> rotations_;
  /// Of each node the nodes that are at most two edges away, itself among them.
  std::vector<std::vector<int>> around_;
};

void move(const Blend& blend, int nearest, std::size_t v, DeformedSurface& surface) {
  const Blend::Moved moved = blend.move(nearest, surface.positions[v], surface.normals[v]);
  surface.positions[v] = moved.position;
  surface.normals[v] = moved.normal;
  surface.inside[v] = moved.inside;
  surface.strain[v] = moved.strain;
}

}  // namespace

std::vector<int> detail_cells(const Pyramid& pyramid, int nodes) {
  std::vector<int> sources(nodes);
  for (int i = 0; i < nodes; ++i) sources[i] = pyramid.proxy.detail_vertex[pyramid.proxy.nodes[i]];
  std::vector<int> nearest = GeodesicSearch(*pyramid.detail.graph).nearest_source(sources).nearest;
  for (int& node : nearest) node = std::max(node, 0);  // A component without a node has none.
  return nearest;
}

DeformedSurface at_rest(std::vector<Point> positions, std::vector<Point> normals,
                        std::vector<elastic::Features> features) {
  const std::size_t count = positions.size();
  return {std::move(positions), std::move(normals), std::move(features),
          std::vector<double>(count, 1.0), std::vector<double>(count, 0.0)};
}

DeformedSurface deformed_surface(const Pyramid& pyramid, const elastic::Deformation& deformation,
                                 const elastic::PointCloud& nodes, const Context& context) {
  const std::vector<int> nearest = detail_cells(pyramid, deformation.size());
  const Blend blend(deformation, nodes);
  DeformedSurface result =
      at_rest(pyramid.surface->mesh.vertices, pyramid.surface->normals, pyramid.detail.features);
  for (std::size_t d = 0; d < nearest.size(); ++d)
    result.features[d].place = blend.place(nearest[d], pyramid.detail.mesh.vertices[d]);
  parallel_for(std::ssize(result.positions), context,
               [&](std::ptrdiff_t v) { move(blend, nearest[pyramid.anchors[v]], v, result); });
  return result;
}

DeformedSurface deformed_surface(const Proxy& proxy, const elastic::Deformation& deformation,
                                 const elastic::PointCloud& nodes) {
  const auto sources = std::span(proxy.nodes).first(deformation.size());
  std::vector<int> nearest = GeodesicSearch(*proxy.graph).nearest_source(sources).nearest;
  for (int& node : nearest) node = std::max(node, 0);  // A component without a node has none.
  const Blend blend(deformation, nodes);
  DeformedSurface result = at_rest(proxy.mesh.vertices, proxy.normals, proxy.features);
  for (std::size_t v = 0; v < nearest.size(); ++v) {
    result.features[v].place = blend.place(nearest[v], result.positions[v]);
    move(blend, nearest[v], v, result);
  }
  return result;
}

}  // namespace isomatch::tracked
