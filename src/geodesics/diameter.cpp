// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "isomatch/geodesics/geodesics.h"

namespace isomatch {
namespace {

constexpr int kMaxRounds = 24;       ///< Of two fields each.
constexpr float kTolerance = 5e-3F;  ///< Relative.

/// What is known of the eccentricities: the distances from each vertex to the one farthest from it.
/// By the triangle inequality a field from v with the eccentricity e bounds that of every vertex u:
/// d(u, v) <= e(u) <= e + d(u, v).
class EccentricityBounds {
 public:
  /// One field from the lowest vertex of each component.
  explicit EccentricityBounds(const GeodesicGraph& graph)
      : lower_(graph.num_vertices(), 0), upper_(lower_.size(), kUnknown) {
    GeodesicSearch search(graph);
    for (int v = 0; v < graph.num_vertices(); ++v) {
      if (upper_[v] != kUnknown) continue;
      const auto component = search.ball(v, kUnknown);
      for (const auto& [u, distance] : component) add(u, distance, component.back().distance);
    }
  }

  void add_field(std::span<const float> distances) {
    float eccentricity = 0;
    for (const float d : distances) {
      if (!std::isinf(d)) eccentricity = std::max(eccentricity, d);
    }
    for (int v = 0; v < static_cast<int>(distances.size()); ++v) {
      if (!std::isinf(distances[v])) add(v, distances[v], eccentricity);
    }
  }

  /// Of the vertices of unknown eccentricity the one that could be the most eccentric, and the one
  /// that certainly is the most.
  std::array<int, 2> most_promising() const {
    int by_upper = 0, by_lower = 0;
    float upper = -1, lower = -1;
    for (int v = 0; v < static_cast<int>(lower_.size()); ++v) {
      if (lower_[v] >= upper_[v]) continue;
      if (upper_[v] > upper) upper = upper_[by_upper = v];
      if (lower_[v] > lower) lower = lower_[by_lower = v];
    }
    return {by_upper, by_lower};
  }

  float largest_lower() const { return std::ranges::max(lower_); }
  float largest_upper() const { return std::ranges::max(upper_); }

 private:
  static constexpr float kUnknown = std::numeric_limits<float>::infinity();

  void add(int vertex, float distance, float eccentricity) {
    // The field's own source: its eccentricity is known exactly.
    const float lower = distance == 0 ? eccentricity : distance;
    lower_[vertex] = std::max(lower_[vertex], lower);
    upper_[vertex] = std::min(upper_[vertex], eccentricity + distance);
  }

  std::vector<float> lower_, upper_;
};

}  // namespace

double geodesic_diameter(const GeodesicGraph& graph, const Context& context) {
  const std::size_t n = graph.num_vertices();
  EccentricityBounds bounds(graph);
  for (int round = 0; round < kMaxRounds; ++round) {
    if (bounds.largest_upper() <= (1 + kTolerance) * bounds.largest_lower()) break;
    const std::vector<float> fields = geodesic_fields(graph, bounds.most_promising(), context);
    bounds.add_field({fields.data(), n});
    bounds.add_field({fields.data() + n, n});
  }
  context.check_stop();
  return bounds.largest_lower();
}

}  // namespace isomatch
