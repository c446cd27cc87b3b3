// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <cmath>
#include <numeric>

#include "geodesics/bundle.h"
#include "isomatch/geodesics/geodesics.h"
#include "parallel.h"

namespace isomatch {
namespace {

/// Arcs to relax below which waking other threads costs more than it saves; about 2 ms.
constexpr std::size_t kParallelWork = 500'000;

/// Fewer sources than this for each thread are not worth a bundle.
constexpr std::ptrdiff_t kFewSources = FieldBundle::kSources / 2;

/// Places in a list of sources, the first of which the others are close to.
using Group = std::vector<int>;

/// Moves the sources that are nearest to the first of `left` from there into a group; `distances`
/// are those from it.
Group nearest_group(std::span<const int> sources, std::span<const float> distances,
                    std::vector<int>& left) {
  auto nearest =
      left.begin() + std::min<std::ptrdiff_t>(std::ssize(left), 1 + FieldBundle::kSources);
  std::ranges::partial_sort(left, nearest, [&](int a, int b) {
    const float x = distances[sources[a]], y = distances[sources[b]];
    return x != y ? x < y : a < b;
  });
  // Not from another component, on whose vertices these distances tell no order.
  nearest = std::find_if(left.begin() + 1, nearest,
                         [&](int place) { return std::isinf(distances[sources[place]]); });
  Group group(left.begin(), nearest);
  left.erase(left.begin(), nearest);
  std::ranges::sort(left);
  return group;
}

}  // namespace

std::vector<float> geodesic_fields(const GeodesicGraph& graph, std::span<const int> sources,
                                   const Context& context) {
  const std::size_t n = graph.num_vertices();
  std::vector<float> fields(sources.size() * n);
  const auto field = [&](int place) { return std::span(fields.data() + place * n, n); };
  const bool little = sources.size() * graph.num_arcs() <= kParallelWork;
  const Context used{.threads = little ? 1 : context.threads, .progress = {}, .stop = context.stop};
  if (std::ssize(sources) < kFewSources * used.threads) {
    parallel_for(
        std::ssize(sources), used, [&] { return GeodesicSearch(graph); },
        [&](GeodesicSearch& search, std::ptrdiff_t i) {
          search.field(sources[i], field(static_cast<int>(i)));
        });
    return fields;
  }
  std::vector<int> left(sources.size());
  std::iota(left.begin(), left.end(), 0);
  std::vector<Group> groups;
  for (GeodesicSearch search(graph); !left.empty();) {
    context.check_stop();
    search.field(sources[left.front()], field(left.front()));
    groups.push_back(nearest_group(sources, field(left.front()), left));
  }
  parallel_for(
      std::ssize(groups), used, [&] { return FieldBundle(graph); },
      [&](FieldBundle& bundle, std::ptrdiff_t i) {
        // The first has its field, by which the vertices are ordered.
        const std::span<const int> others = std::span(groups[i]).subspan(1);
        std::vector<int> vertices;
        std::vector<float*> rows;
        for (const int place : others) {
          vertices.push_back(sources[place]);
          rows.push_back(field(place).data());
        }
        bundle.run(vertices, field(groups[i].front()), rows);
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
