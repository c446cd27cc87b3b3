// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/sampling.h"

#include <algorithm>
#include <utility>

#include "isomatch/error.h"
#include "isomatch/methods/sampling.h"
#include "parallel.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"

namespace isomatch {

BaseSampling sample_bases(const MetricSurface& shape, std::span<const int> order,
                          std::span<const int> inherited, float radius, const Context& context) {
  BaseSampling sampling{radius, {inherited.begin(), inherited.end()}, 0};
  std::vector<bool> covered(shape.num_vertices(), false);
  GeodesicSearch search(shape.graph());
  const auto cover_patch = [&](int base) {
    context.check_stop();
    double area = 0;
    for (const auto& [v, distance] : search.ball(base, radius)) {
      if (v == base || radius > 0) covered[v] = true;
      area += shape.vertex_areas()[v];
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

BaseNeighbourhoods::BaseNeighbourhoods(const MetricSurface& shape, std::span<const int> bases,
                                       float cutoff, const Context& context)
    : cutoff_(cutoff) {
  const int count = static_cast<int>(bases.size());
  std::vector<int> base_of_vertex(shape.num_vertices(), -1);
  for (int b = 0; b < count; ++b) base_of_vertex[bases[b]] = b;
  std::vector<std::vector<Neighbour>> lists(count);
  parallel_for(
      count, context, [&] { return GeodesicSearch(shape.graph()); },
      [&](GeodesicSearch& search, std::ptrdiff_t b) {
        for (const auto& [v, distance] : search.ball(bases[b], cutoff)) {
          if (base_of_vertex[v] >= 0) lists[b].push_back({base_of_vertex[v], distance});
        }
        std::ranges::sort(lists[b], {}, &Neighbour::base);
      });
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

std::vector<int> sample_bases(const Shape& shape, std::span<const int> order, double radius,
                              const Context& context) {
  if (!(radius >= 0)) throw InvalidInput("radius must not be negative");
  const Surface& surface = *shape.prepared().surface();
  const SurfaceVertices first = on_surface(surface, order, "order: vertex");
  const auto scaled = static_cast<float>(radius / surface.scale);
  BaseSampling sampling =
      sample_bases(shape.prepared().metric(context), *first, {}, scaled, context);
  return to_input(surface, SurfaceVertices(std::move(sampling.bases)));
}

}  // namespace isomatch
