// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/geodesics.h"

#include <algorithm>
#include <limits>
#include <queue>

#include "isomatch/error.h"
#include "isomatch/topology.h"

namespace isomatch {
namespace {
constexpr float kInfinity = std::numeric_limits<float>::infinity();
}

void GeodesicOptions::validate() const {
  if (!(window_angle > 0 && window_angle <= 60))
    throw InvalidInput("window_angle must be in (0, 60] degrees");
}

GeodesicGraph::GeodesicGraph(const Mesh& mesh, const GeodesicOptions& options, const Context&) {
  options.validate();
  const IndexLists faces = vertex_faces(mesh);
  offsets_.assign(1, 0);
  double total = 0;
  std::vector<int> heads;
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    heads.clear();
    for (int f : faces[v])
      for (int u : mesh.faces[f])
        if (u != v) heads.push_back(u);
    std::sort(heads.begin(), heads.end());
    heads.erase(std::unique(heads.begin(), heads.end()), heads.end());
    for (int u : heads) {
      const float length = static_cast<float>((mesh.vertices[u] - mesh.vertices[v]).norm());
      arcs_.push_back({u, length});
      total += length;
    }
    offsets_.push_back(arcs_.size());
  }
  mean_edge_length_ = static_cast<float>(total / static_cast<double>(std::max<size_t>(1, arcs_.size())));
}

GeodesicSearch::GeodesicSearch(const GeodesicGraph& graph)
    : graph_(&graph), distances_(graph.num_vertices(), kInfinity) {}

std::span<const GeodesicSearch::Reached> GeodesicSearch::ball(int source, float radius) {
  using Item = std::pair<float, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  reached_.clear();
  std::vector<int> touched{source};
  distances_[source] = 0;
  queue.push({0.f, source});
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distances_[v]) continue;
    reached_.push_back({v, d});
    for (const auto& arc : graph_->arcs(v)) {
      const float nd = d + arc.length;
      if (nd <= radius && nd < distances_[arc.head]) {
        if (distances_[arc.head] == kInfinity) touched.push_back(arc.head);
        distances_[arc.head] = nd;
        queue.push({nd, arc.head});
      }
    }
  }
  for (int v : touched) distances_[v] = kInfinity;
  return reached_;
}

void GeodesicSearch::field(int source, std::span<float> distances) {
  std::fill(distances.begin(), distances.end(), kInfinity);
  for (const Reached& r : ball(source, std::numeric_limits<float>::max())) distances[r.vertex] = r.distance;
}

float GeodesicSearch::distance(int from, int to) {
  for (const Reached& r : ball(from, std::numeric_limits<float>::max()))
    if (r.vertex == to) return r.distance;
  return kInfinity;
}

std::vector<float> geodesic_fields(const GeodesicGraph& graph, std::span<const int> sources,
                                   const Context& context) {
  const std::size_t n = graph.num_vertices();
  std::vector<float> fields(sources.size() * n);
#pragma omp parallel num_threads(context.threads)
  {
    GeodesicSearch search(graph);
#pragma omp for schedule(dynamic)
    for (std::size_t i = 0; i < sources.size(); ++i)
      search.field(sources[i], {fields.data() + i * n, n});
  }
  return fields;
}

}  // namespace isomatch
