// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/proxy.h"

#include <meshoptimizer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "face_orientation.h"
#include "tracked/relief.h"

namespace isomatch::tracked {
namespace {

using Index = unsigned int;

/// Corners of the faces of `mesh` with about `count` of its vertices.
std::vector<Index> simplified(const Mesh& mesh, int count) {
  std::vector<Index> indices;
  indices.reserve(mesh.faces.size() * 3);
  for (const Face& face : mesh.faces) indices.insert(indices.end(), face.begin(), face.end());
  if (mesh.num_vertices() <= count) return indices;
  std::vector<float> positions;
  positions.reserve(mesh.vertices.size() * 3);
  for (const Point& p : mesh.vertices)
    for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(p[k]));
  std::vector<Index> result(indices.size());
  const std::size_t target = std::min(static_cast<std::size_t>(count) * 6, indices.size());
  result.resize(meshopt_simplify(result.data(), indices.data(), indices.size(), positions.data(),
                                 mesh.vertices.size(), 3 * sizeof(float), target, 1.0F, 0,
                                 nullptr));
  return result;
}

void take_vertices(const Mesh& mesh, const std::vector<Index>& corners, Proxy& proxy) {
  std::vector<int> renumbered(mesh.vertices.size(), kNoVertex);
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    int& vertex = renumbered[corners[corner]];
    if (vertex == kNoVertex) {
      vertex = proxy.num_vertices();
      proxy.mesh.vertices.push_back(mesh.vertices[corners[corner]]);
      proxy.surface_vertex.push_back(static_cast<int>(corners[corner]));
    }
    if (corner % 3 == 0) proxy.mesh.faces.emplace_back();
    proxy.mesh.faces.back()[corner % 3] = vertex;
  }
}

std::vector<Point> unit_normals(const Mesh& mesh) {
  std::vector<Point> normals = weighted_vertex_normals(mesh);
  for (Point& normal : normals) normal.normalize();
  return normals;
}

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

void measure_distances(const GeodesicGraph& graph, Proxy& proxy, const Context& context) {
  const std::size_t n = proxy.mesh.vertices.size();
  proxy.distances.resize(proxy.num_nodes(), static_cast<Eigen::Index>(n));
#pragma omp parallel num_threads(context.threads)
  {
    GeodesicSearch search(graph);
#pragma omp for schedule(dynamic, 16)
    for (int i = 0; i < proxy.num_nodes(); ++i)
      search.field(proxy.nodes[i], {proxy.distances.row(i).data(), n});
  }
}

}  // namespace

UnitSurface unit_surface(const Shape& shape, bool mirrored) {
  UnitSurface surface;
  Mesh& mesh = surface.mesh;
  mesh = shape.surface.mesh;
  surface.faces = vertex_faces(mesh);
  surface.scale = std::sqrt(shape.surface.area);
  surface.centre = std::accumulate(mesh.vertices.begin(), mesh.vertices.end(), Point(0, 0, 0)) /
                   mesh.num_vertices();
  for (Point& p : mesh.vertices) {
    p = (p - surface.centre) / surface.scale;
    if (mirrored) p[0] = -p[0];
  }
  const auto signs = face_orientation(mesh);
  surface.oriented = signs.has_value();
  surface.turned.assign(mesh.faces.size(), false);
  for (int f = 0; surface.oriented && f < mesh.num_faces(); ++f) {
    surface.turned[f] = (*signs)[f] < 0;
    if (surface.turned[f]) std::swap(mesh.faces[f][1], mesh.faces[f][2]);
  }
  surface.normals = unit_normals(mesh);
  for (const auto& relief : relief(mesh, surface.normals)) surface.features.push_back({relief, {}});
  return surface;
}

NodeGraph node_graph(const Proxy& proxy, int count) {
  count = std::min(count, proxy.num_nodes());
  std::vector<int> nearest(proxy.mesh.vertices.size());
  for (int v = 0; v < proxy.num_vertices(); ++v)
    proxy.distances.col(v).head(count).minCoeff(&nearest[v]);
  NodeGraph graph;
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

Proxy make_proxy(const UnitSurface& surface, const ProxyOptions& options, const Context& context) {
  Proxy proxy;
  proxy.oriented = surface.oriented;
  take_vertices(surface.mesh, simplified(surface.mesh, options.vertices), proxy);
  for (int v : proxy.surface_vertex) proxy.features.push_back(surface.features[v]);
  proxy.faces = vertex_faces(proxy.mesh);
  proxy.normals = unit_normals(proxy.mesh);
  const GeodesicGraph graph(proxy.mesh, {}, context);
  proxy.nodes = spread_nodes(graph, options.nodes);
  measure_distances(graph, proxy, context);
  for (int v = 0; v < proxy.num_vertices(); ++v)
    for (int k = 0; k < std::min(elastic::kPlaces, proxy.num_nodes()); ++k)
      proxy.features[v].place[k] = proxy.distances(k, v);
  return proxy;
}

}  // namespace isomatch::tracked
