// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "group/likeness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "isomatch/geodesics/geodesics.h"
#include "parallel.h"

namespace isomatch::group {
namespace {

using Ends = std::vector<std::pair<int, int>>;

/// Pairs of evenly spread vertices that are near each other.
Ends near_pairs(const Surface& surface, const Context& context) {
  // A few dozen samples a limb, of which each has some ten neighbours.
  constexpr int kSamples = 300;
  constexpr float kReach = 0.2F;
  const GeodesicGraph graph(surface.mesh, GeodesicOptions::edges(), context);
  std::vector<int> vertices(surface.num_vertices());
  std::iota(vertices.begin(), vertices.end(), 0);
  const std::vector<int> samples = farthest_points(graph, vertices, kSamples, 0, context);
  std::vector<bool> sampled(vertices.size(), false);
  for (const int sample : samples) sampled[sample] = true;
  GeodesicSearch search(graph);
  Ends ends;
  for (const int sample : samples)
    for (const auto& reached : search.ball(sample, kReach))
      if (sampled[reached.vertex] && reached.vertex > sample)
        ends.emplace_back(sample, reached.vertex);
  return ends;
}

std::vector<float> lengths_on(const Surface& surface, const Places& places, const Ends& ends) {
  std::vector<float> lengths;
  lengths.reserve(ends.size());
  for (const auto& [a, b] : ends) {
    const bool known = places[a].face != kNoFace && places[b].face != kNoFace;
    lengths.push_back(
        known ? static_cast<float>(
                    (position(surface.mesh, places[a]) - position(surface.mesh, places[b])).norm())
              : std::numeric_limits<float>::quiet_NaN());
  }
  return lengths;
}

}  // namespace

Likeness::Likeness(const std::vector<const Surface*>& surfaces, const std::vector<Places>& places,
                   int template_shape, const Context& context)
    : lengths_(places.size()) {
  const Ends ends = near_pairs(*surfaces[template_shape], context);
  parallel_for(std::ssize(places), context,
               [&](std::ptrdiff_t k) { lengths_[k] = lengths_on(*surfaces[k], places[k], ends); });
}

double Likeness::difference(int a, int b) const {
  double sum = 0;
  int count = 0;
  for (std::size_t k = 0; k < lengths_[a].size(); ++k) {
    const double change = lengths_[a][k] - lengths_[b][k];
    if (std::isnan(change)) continue;
    sum += change * change;
    ++count;
  }
  return count == 0 ? std::numeric_limits<double>::infinity() : std::sqrt(sum / count);
}

int Likeness::most_central(const std::vector<bool>& eligible) const {
  const auto count = static_cast<int>(lengths_.size());
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int a = 0; a < count; ++a) {
    if (!eligible[a]) continue;
    double sum = 0;
    for (int b = 0; b < count; ++b) sum += difference(a, b);
    if (best >= 0 && sum >= least) continue;
    best = a;
    least = sum;
  }
  return best;
}

std::vector<int> Likeness::nearest(int shape, int count) const {
  std::vector<std::pair<double, int>> others;
  for (int other = 0; std::cmp_less(other, lengths_.size()); ++other)
    if (other != shape) others.emplace_back(difference(shape, other), other);
  std::ranges::sort(others);
  std::vector<int> nearest;
  for (const auto& [difference, other] : others)
    if (std::cmp_less(nearest.size(), count)) nearest.push_back(other);
  return nearest;
}

}  // namespace isomatch::group
