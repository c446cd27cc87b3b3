// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/model.h"

#include <algorithm>

namespace isomatch::tracked {
namespace {

spectral::Samples samples_at(const Proxy& proxy, const spectral::Eigenbasis& basis,
                             const elastic::PointCloud& cloud) {
  spectral::Samples samples;
  const auto n = static_cast<Eigen::Index>(cloud.areas.size());
  samples.functions.resize(n, basis.functions.cols());
  samples.areas.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    samples.functions.row(i) = basis.functions.row(proxy.nodes[i]);
    samples.areas[i] = static_cast<float>(cloud.areas[i]);
  }
  return samples;
}

Level make_level(const Proxy& proxy, const spectral::Eigenbasis& basis, int nodes) {
  Level level{node_graph(proxy, nodes), {}};
  level.samples = samples_at(proxy, basis, level.graph.cloud);
  return level;
}

/// The vertices of the detail from which places are measured, as the proxy has them.
std::vector<int> place_vertices(const Proxy& proxy) {
  std::vector<int> vertices;
  for (int k = 0; k < std::min(elastic::kPlaces, proxy.num_measured()); ++k)
    vertices.push_back(proxy.detail_vertex[proxy.nodes[k]]);
  return vertices;
}

}  // namespace

Model make_model(const Surface& surface, bool mirrored, const TrackerOptions& options,
                 const Context& context) {
  int steps = 0;
  const auto stepped = [&](auto result) {
    context.report(static_cast<double>(++steps) / kModelSteps, "model");
    return result;
  };
  UnitSurface unit = stepped(unit_surface(surface, mirrored));
  Detail detail = stepped(make_detail(unit, options.detail_vertices, context));
  Proxy proxy = stepped(make_proxy(detail, unit.oriented, options.proxy, context));
  set_places(detail, place_vertices(proxy), context);
  std::vector<int> anchor = stepped(anchors(unit, detail, context));
  spectral::Eigenbasis basis =
      stepped(spectral::eigenbasis(proxy.mesh, options.last_basis, context));
  Model model{std::move(unit),
              std::move(detail),
              std::move(anchor),
              std::move(proxy),
              std::move(basis),
              {},
              {},
              {},
              mirrored};
  model.coarse = make_level(model.proxy, model.basis, options.coarse_nodes);
  model.middle = make_level(model.proxy, model.basis, options.middle_nodes);
  model.fine = make_level(model.proxy, model.basis, options.proxy.nodes);
  return stepped(std::move(model));
}

int nearest_node(const Model& model, int surface_vertex, int count) {
  const Point& p = model.surface.mesh.vertices[surface_vertex];
  const auto nodes = std::span(model.fine.graph.cloud.positions).first(count);
  const auto nearest = std::ranges::min_element(
      nodes, {}, [&](const Point& node) { return (node - p).squaredNorm(); });
  return static_cast<int>(nearest - nodes.begin());
}

std::vector<int> node_vertices(const Proxy& proxy, std::vector<int> nodes) {
  for (int& node : nodes) node = proxy.nodes[node];
  return nodes;
}

std::vector<Point> selected(const std::vector<Point>& points, const std::vector<int>& indices) {
  std::vector<Point> result;
  for (int i : indices) result.push_back(points[i]);
  return result;
}

elastic::Projection projection_onto(const Proxy& proxy, const elastic::ProjectionWeights& weights) {
  return {proxy.mesh, proxy.faces, proxy.normals, proxy.features, weights};
}

void set_places(elastic::PointCloud& cloud, const Proxy& target, std::span<const int> vertices) {
  for (std::size_t i = 0; i < cloud.features.size(); ++i)
    cloud.features[i].place = target.features[vertices[i]].place;
}

}  // namespace isomatch::tracked
