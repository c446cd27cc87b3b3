// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/sampling.h"

#include <algorithm>

namespace isomatch {

BaseSampling sample_bases(const Shape& shape, std::span<const int> order,
                          std::span<const int> inherited, float radius) {
  BaseSampling sampling{radius, {inherited.begin(), inherited.end()}, 0};
  std::vector<bool> covered(shape.num_vertices(), false);
  GeodesicSearch search(shape.graph);
  const auto cover_patch = [&](int base) {
    double area = 0;
    for (const auto& [v, distance] : search.ball(base, radius)) {
      if (v == base || radius > 0) covered[v] = true;
      area += shape.vertex_areas[v];
    }
    sampling.largest_patch_area = std::max(sampling.largest_patch_area, area);
  };
  for (int base : inherited) cover_patch(base);
  for (int v : order) {
    if (covered[v]) continue;
    sampling.bases.push_back(v);
    cover_patch(v);
  }
  return sampling;
}

BaseNeighbourhoods::BaseNeighbourhoods(const Shape& shape, std::span<const int> bases, float cutoff,
                                       const Context& context)
    : cutoff_(cutoff) {
  const int count = static_cast<int>(bases.size());
  std::vector<int> base_of_vertex(shape.num_vertices(), -1);
  for (int b = 0; b < count; ++b) base_of_vertex[bases[b]] = b;
  std::vector<std::vector<Neighbour>> lists(count);
#pragma omp parallel num_threads(context.threads)
  {
    GeodesicSearch search(shape.graph);
#pragma omp for schedule(dynamic, 16)
    for (int b = 0; b < count; ++b) {
      for (const auto& [v, distance] : search.ball(bases[b], cutoff)) {
        if (base_of_vertex[v] >= 0) lists[b].push_back({base_of_vertex[v], distance});
      }
      std::sort(lists[b].begin(), lists[b].end(),
                [](const Neighbour& x, const Neighbour& y) { return x.base < y.base; });
    }
  }
  for (const auto& list : lists) {
    neighbours_.insert(neighbours_.end(), list.begin(), list.end());
    offsets_.push_back(neighbours_.size());
  }
}

float BaseNeighbourhoods::distance(int a, int b) const {
  const auto list = (*this)[a];
  const auto found = std::lower_bound(list.begin(), list.end(), b,
                                      [](const Neighbour& x, int base) { return x.base < base; });
  return found != list.end() && found->base == b ? found->distance : cutoff_;
}

}  // namespace isomatch
