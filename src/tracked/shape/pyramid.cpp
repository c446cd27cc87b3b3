// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/pyramid.h"

#include <algorithm>
#include <utility>

#include "shape/boundary.h"

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

/// The surface as it is seen; itself where that is as it is.
std::shared_ptr<const Surface> seen(const PreparedShape& shape, const View& view) {
  std::shared_ptr<const Surface> surface = shape.surface();
  if (view.mirrored) surface = std::make_shared<const Surface>(mirror_image(*surface));
  if (view.size != 1) surface = std::make_shared<const Surface>(scaled(*surface, view.size));
  return surface;
}

}  // namespace

Pyramid make_pyramid(const PreparedShape& shape, const View& view, const PyramidOptions& options,
                     const Context& context) {
  int steps = 0;
  const auto stepped = [&](auto result) {
    context.report(static_cast<double>(++steps) / kPyramidSteps, "shapes");
    return result;
  };
  Pyramid pyramid;
  pyramid.view = view;
  pyramid.surface = seen(shape, view);
  if (view.open) pyramid.rim = boundary_vertices(pyramid.surface->mesh);
  const Surface& surface = *pyramid.surface;
  pyramid.detail = stepped(make_detail(shape, surface, options, context));
  if (!view.cut.empty()) pyramid.detail = without(pyramid.detail, view.cut, context);
  pyramid.proxy =
      stepped(make_proxy(pyramid.detail, surface.oriented, view.open, options.proxy, context));
  set_places(pyramid.detail, place_vertices(pyramid.proxy), context);
  pyramid.anchors = stepped(anchors(surface, pyramid.detail, context));
  pyramid.basis = stepped(spectral::eigenbasis(pyramid.proxy.mesh, options.functions, context));
  pyramid.coarse = make_level(pyramid.proxy, pyramid.basis, options.coarse_nodes);
  pyramid.middle = make_level(pyramid.proxy, pyramid.basis, options.middle_nodes);
  pyramid.fine = make_level(pyramid.proxy, pyramid.basis, options.proxy.nodes);
  return stepped(std::move(pyramid));
}

std::shared_ptr<const Pyramid> pyramid_of(const PreparedShape& shape, const View& view,
                                          const PyramidOptions& options, const Context& context) {
  using Key = std::pair<PyramidOptions, View>;
  return shape.kept<Memo<Key, Pyramid>>().get(
      {options, view}, [&] { return make_pyramid(shape, view, options, context); });
}

std::vector<int> nearest_vertices(const Mesh& mesh, const std::vector<elastic::Foot>& feet) {
  std::vector<int> vertices;
  for (const elastic::Foot& foot : feet) vertices.push_back(heaviest_corner(mesh, foot.point));
  return vertices;
}

std::vector<int> rim_of(const Proxy& proxy) {
  std::vector<int> rim;
  for (int v = 0; v < proxy.num_vertices(); ++v)
    if (proxy.to_boundary[v] == 0) rim.push_back(v);
  return rim;
}

int nearest_node(const Pyramid& pyramid, int surface_vertex, int count) {
  const Point& p = pyramid.surface->mesh.vertices[surface_vertex];
  const auto nodes = std::span(pyramid.fine.graph.cloud.positions).first(count);
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
  return {proxy.mesh, proxy.faces, proxy.normals, proxy.features, weights, rim_of(proxy)};
}

void set_places(elastic::PointCloud& cloud, const Proxy& target, std::span<const int> vertices) {
  for (std::size_t i = 0; i < cloud.features.size(); ++i)
    cloud.features[i].place = target.features[vertices[i]].place;
}

}  // namespace isomatch::tracked
