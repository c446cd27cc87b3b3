// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/local_shape.h"

#include <algorithm>
#include <cmath>

#include "shape/surface.h"

namespace isomatch::tracked {
namespace {

constexpr int kRings = 3, kHeights = 7, kTurns = 5, kBinsOfARing = kHeights * kTurns;

/// A value in [-1, 1] shared between the two bins that are closest.
struct Bins {
  int first;
  float second_share;
};

Bins bins(double value, int count) {
  const double at = std::clamp((value + 1) / 2, 0.0, 1.0) * (count - 1);
  const int first = std::min(static_cast<int>(at), count - 2);
  return {first, static_cast<float>(at - first)};
}

/// The mean normal close to a node, which does not depend on details.
Point normal_around(const Proxy& proxy, int node, const std::vector<double>& areas, float radius) {
  Point sum = Point::Zero();
  for (int v = 0; v < proxy.num_vertices(); ++v)
    if (proxy.distances(node, v) < radius) sum += areas[v] * proxy.normals[v];
  return sum.normalized();
}

void add(double height, double cosine, float area, float* ring) {
  const Bins h = bins(height, kHeights), c = bins(cosine, kTurns);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      ring[(h.first + i) * kTurns + c.first + j] += area *
                                                    (i == 0 ? 1 - h.second_share : h.second_share) *
                                                    (j == 0 ? 1 - c.second_share : c.second_share);
}

/// The rings within one radius.
void describe(const Proxy& proxy, int node, const std::vector<double>& areas, float radius,
              float* histogram) {
  const Point& centre = proxy.node_position(node);
  const Point normal = normal_around(proxy, node, areas, radius / kRings);
  for (int v = 0; v < proxy.num_vertices(); ++v) {
    const float distance = proxy.distances(node, v);
    if (distance >= radius) continue;
    const auto ring = static_cast<int>(kRings * distance / radius);
    add((proxy.mesh.vertices[v] - centre).dot(normal) / radius, proxy.normals[v].dot(normal),
        static_cast<float>(areas[v]), histogram + ring * kBinsOfARing);
  }
  for (int ring = 0; ring < kRings; ++ring) {
    float* first = histogram + ring * kBinsOfARing;
    float sum = 0;
    for (int bin = 0; bin < kBinsOfARing; ++bin) sum += first[bin];
    if (sum > 0)
      for (int bin = 0; bin < kBinsOfARing; ++bin) first[bin] /= sum;
  }
}

}  // namespace

FloatMatrix local_shapes(const Proxy& proxy, const std::vector<int>& nodes,
                         const LocalShapeOptions& options) {
  const std::vector<double> areas = vertex_areas(proxy.mesh);
  const auto bins_of_a_radius = static_cast<Eigen::Index>(kRings) * kBinsOfARing;
  FloatMatrix shapes = FloatMatrix::Zero(static_cast<Eigen::Index>(nodes.size()),
                                         bins_of_a_radius * std::ssize(options.radii));
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (std::size_t r = 0; r < options.radii.size(); ++r)
      describe(proxy, nodes[k], areas, options.radii[r],
               shapes.row(static_cast<Eigen::Index>(k)).data() +
                   static_cast<Eigen::Index>(r) * bins_of_a_radius);
  return shapes;
}

}  // namespace isomatch::tracked
