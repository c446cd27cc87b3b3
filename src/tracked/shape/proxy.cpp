// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/proxy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <span>
#include <vector>

#include "geometry/simplify.h"
#include "shape/boundary.h"
#include "shape/surface.h"

namespace isomatch::tracked {
namespace {

/// Evenly spread vertices; the first does not depend on the numbering.
std::vector<int> spread_nodes(const GeodesicGraph& graph, int count) {
  std::vector<int> all(graph.num_vertices());
  std::iota(all.begin(), all.end(), 0);
  std::vector<float> distances(all.size());
  GeodesicSearch search(graph);
  int start = 0;
  for (int step = 0; step < 3; ++step) {
    search.field(start, distances);
    start = static_cast<int>(std::ranges::max_element(distances) - distances.begin());
  }
  return farthest_points(graph, all, count, start);
}

/// Distances to what is not connected become somewhat longer than all others.
void hold_to_reached(FloatMatrix& distances) {
  float longest = 0;
  for (const float d : distances.reshaped())
    if (std::isfinite(d)) longest = std::max(longest, d);
  for (float& d : distances.reshaped())
    if (!std::isfinite(d)) d = 1.5F * longest;
}

void measure_distances(Proxy& proxy, int most, const Context& context) {
  const std::span<const int> measured =
      std::span(proxy.nodes).first(std::min(proxy.num_nodes(), most));
  const std::vector<float> fields = geodesic_fields(*proxy.graph, measured, context);
  proxy.distances = Eigen::Map<const FloatMatrix>(fields.data(), std::ssize(measured),
                                                  std::ssize(proxy.mesh.vertices));
  hold_to_reached(proxy.distances);
}

std::vector<float> distances_to_boundary(const Proxy& proxy, bool open) {
  const std::vector<int> boundary = open ? boundary_vertices(proxy.mesh) : std::vector<int>();
  if (boundary.empty())
    return std::vector<float>(proxy.mesh.vertices.size(), std::numeric_limits<float>::infinity());
  return GeodesicSearch(*proxy.graph).nearest_source(boundary).distances;
}

}  // namespace

std::shared_ptr<const std::vector<SecondForm>> second_forms_of(const Proxy& proxy, double length) {
  return proxy.kept_forms->get(length, [&] { return second_forms(proxy.mesh, length); });
}

NodeGraph node_graph(const Proxy& proxy, int count) {
  count = std::min(count, proxy.num_nodes());
  NodeGraph graph;
  graph.cell =
      GeodesicSearch(*proxy.graph).nearest_source(std::span(proxy.nodes).first(count)).nearest;
  for (int& node : graph.cell) node = std::max(node, 0);  // A component without a node has none.
  const std::vector<int>& nearest = graph.cell;
  graph.cloud.areas.assign(count, 0.0);
  const std::vector<double> areas = vertex_areas(proxy.mesh);
  for (int v = 0; v < proxy.num_vertices(); ++v) graph.cloud.areas[nearest[v]] += areas[v];
  std::vector<std::set<int>> touching(count);
  for (const Face& face : proxy.mesh.faces) {
    for (int k = 0; k < 3; ++k) {
      const int a = nearest[face[k]], b = nearest[face[(k + 1) % 3]];
      if (a == b) continue;
      touching[a].insert(b);
      touching[b].insert(a);
    }
  }
  std::vector<int> offsets{0}, values;
  for (int i = 0; i < count; ++i) {
    graph.cloud.positions.push_back(proxy.node_position(i));
    graph.cloud.normals.push_back(proxy.node_normal(i));
    graph.cloud.features.push_back(proxy.features[proxy.nodes[i]]);
    values.insert(values.end(), touching[i].begin(), touching[i].end());
    offsets.push_back(static_cast<int>(values.size()));
  }
  graph.neighbours = IndexLists(std::move(offsets), std::move(values));
  return graph;
}

Proxy make_proxy(const Detail& detail, bool oriented, bool open, const ProxyOptions& options,
                 const Context& context) {
  SimplifiedMesh simplified = simplify(detail.mesh, options.vertices);
  const bool is_whole = simplified.kept.size() == detail.mesh.vertices.size();
  auto graph =
      is_whole ? detail.graph
               : std::make_shared<const GeodesicGraph>(simplified.mesh, GeodesicOptions{}, context);
  Proxy proxy{std::move(simplified.mesh),
              std::move(simplified.kept),
              {},
              oriented,
              {},
              {},
              {},
              std::move(graph),
              {},
              {}};
  for (int v : proxy.detail_vertex) proxy.features.push_back(detail.features[v]);
  proxy.faces = vertex_faces(proxy.mesh);
  proxy.normals = unit_normals(proxy.mesh);
  proxy.nodes = spread_nodes(*proxy.graph, options.nodes);
  measure_distances(proxy, options.measured_nodes, context);
  proxy.to_boundary = distances_to_boundary(proxy, open);
  for (int v = 0; v < proxy.num_vertices(); ++v)
    for (int k = 0; k < std::min(elastic::kPlaces, proxy.num_measured()); ++k)
      proxy.features[v].place[k] = proxy.distances(k, v);
  return proxy;
}

}  // namespace isomatch::tracked
