// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/geodesics/geodesics.h"
#include "parallel.h"

namespace isomatch {
namespace {

/// Arcs to relax below which waking other threads costs more than it saves; about 2 ms.
constexpr std::size_t kParallelWork = 500'000;

}  // namespace

std::vector<float> geodesic_fields(const GeodesicGraph& graph, std::span<const int> sources,
                                   const Context& context) {
  const std::size_t n = graph.num_vertices();
  std::vector<float> fields(sources.size() * n);
  const bool little = sources.size() * graph.num_arcs() <= kParallelWork;
  const Context used{.threads = little ? 1 : context.threads, .progress = {}, .stop = context.stop};
  parallel_for(
      std::ssize(sources), used, [&] { return GeodesicSearch(graph); },
      [&](GeodesicSearch& search, std::ptrdiff_t i) {
        search.field(sources[i], {fields.data() + i * n, n});
      });
  return fields;
}

std::vector<int> farthest_points(const GeodesicGraph& graph, std::span<const int> candidates,
                                 int count, int first, const Context& context) {
  std::vector<int> places;
  std::vector<float> distances(graph.num_vertices(), std::numeric_limits<float>::infinity());
  GeodesicSearch search(graph);
  for (int next = first; static_cast<int>(places.size()) < count;) {
    context.check_stop();
    places.push_back(next);
    search.update_field(candidates[next], distances);
    const auto farthest = std::ranges::max_element(
        candidates, {}, [&](int candidate) { return distances[candidate]; });
    if (distances[*farthest] == 0) break;
    next = static_cast<int>(farthest - candidates.begin());
  }
  return places;
}

}  // namespace isomatch
