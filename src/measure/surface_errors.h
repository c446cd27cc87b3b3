// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "isomatch/measure/metrics.h"
#include "shape/metric_surface.h"
#include "shape/numbers.h"

/// What errors against a truth are made of: distances on the target, in the numbers of its surface.
namespace isomatch {

/// Two vertices of the target whose distance is an error.
struct ErrorPair {
  int truth;
  int mapped;
};

/// A vertex and a point of the target whose distance is an error.
struct PointPair {
  int truth;
  SurfacePoint mapped;
};

/// Two points of the target whose distance is an error.
struct TwoPoints {
  SurfacePoint truth;
  SurfacePoint mapped;
};

/// Throws `InvalidInput` if the lists differ in length.
void check_truth(const GroundTruth& truth);

/// The vertex of a template point on a surface, `kNoVertex` where it is missing or not part of it.
int surface_place(const Surface& surface, int input_vertex);

/// The matches of each source vertex lie together in a sorted correspondence.
std::span<const Match> matches_of(const Correspondence& matches, int source);

/// The distances of pairs, relative to sqrt(area).
std::vector<double> distances(const MetricSurface& target, const std::vector<ErrorPair>& pairs,
                              const Context& context);
/// The distance d from a vertex to a point x of weights w follows from the distances d_i to the
/// corners p_i of its triangle, d^2 = sum w_i d_i^2 - sum w_i |p_i - x|^2.
std::vector<double> distances(const MetricSurface& target, const std::vector<PointPair>& pairs,
                              const Context& context);
/// The same applied at both ends; a straight line where both points lie in one triangle.
std::vector<double> distances(const MetricSurface& target, const std::vector<TwoPoints>& pairs,
                              const Context& context);

/// Statistics of `errors` over `unit`.
ErrorStatistics error_statistics(std::vector<double> errors, double unit);

/// At most `max_samples` of the pairs, evenly spaced in their order.
template <class Pair>
std::vector<Pair> evenly_thinned(const std::vector<Pair>& pairs, int max_samples) {
  if (std::ssize(pairs) <= max_samples) return pairs;
  std::vector<Pair> thinned(max_samples);
  for (std::size_t i = 0; i < thinned.size(); ++i)
    thinned[i] = pairs[i * pairs.size() / thinned.size()];
  return thinned;
}

/// The mean of what is measured at each vertex of the caller's, NaN where nothing is.
class VertexMeans {
 public:
  explicit VertexMeans(const Surface& source)
      : source_(source), sum_(source.num_vertices(), 0.0), count_(sum_) {}

  void add(int vertex, double value) {
    sum_[vertex] += value;
    ++count_[vertex];
  }
  std::vector<double> means() const;

 private:
  const Surface& source_;
  std::vector<double> sum_, count_;
};

}  // namespace isomatch
