// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "measure/surface_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "parallel.h"

namespace isomatch {
namespace {

double distance(const Mesh&, GeodesicSearch& search, const ErrorPair& pair) {
  return search.distance(pair.truth, pair.mapped);
}

/// The sum of w_i (d_i^2 - |p_i - x|^2) over the corners p_i of a point x, where `squared` gives
/// d_i^2.
template <class Squared>
double squared_from_corners(const Mesh& mesh, const SurfacePoint& point, const Squared& squared) {
  const Point x = position(mesh, point);
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double weight = point.weights[k];
    if (weight == 0) continue;
    const int corner = mesh.faces[point.face][k];
    sum += weight * (squared(corner) - (mesh.vertices[corner] - x).squaredNorm());
  }
  return sum;
}

double squared_distance(const Mesh& mesh, GeodesicSearch& search, int from,
                        const SurfacePoint& to) {
  return squared_from_corners(mesh, to, [&](int corner) {
    const double distance = search.distance(from, corner);
    return distance * distance;
  });
}

double distance(const Mesh& mesh, GeodesicSearch& search, const PointPair& pair) {
  return std::sqrt(std::max(0.0, squared_distance(mesh, search, pair.truth, pair.mapped)));
}

bool lies_in(const Mesh& mesh, const SurfacePoint& point, const Face& face) {
  for (int k = 0; k < 3; ++k)
    if (point.weights[k] != 0 && std::ranges::find(face, mesh.faces[point.face][k]) == face.end())
      return false;
  return true;
}

double distance(const Mesh& mesh, GeodesicSearch& search, const TwoPoints& pair) {
  const SurfacePoint &truth = pair.truth, &mapped = pair.mapped;
  if (lies_in(mesh, truth, mesh.faces[mapped.face]) ||
      lies_in(mesh, mapped, mesh.faces[truth.face]))
    return (position(mesh, truth) - position(mesh, mapped)).norm();
  const double squared = squared_from_corners(mesh, truth, [&](int corner) {
    return std::max(0.0, squared_distance(mesh, search, corner, mapped));
  });
  return std::sqrt(std::max(0.0, squared));
}

template <class Pair>
std::vector<double> all_distances(const MetricSurface& target, const std::vector<Pair>& pairs,
                                  const Context& context) {
  std::vector<double> result(pairs.size(), 0.0);
  parallel_for(
      std::ssize(pairs), context, [&] { return GeodesicSearch(target.graph()); },
      [&](GeodesicSearch& search, std::ptrdiff_t i) {
        result[i] = distance(target.mesh(), search, pairs[i]);
      });
  return result;
}

double percentile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const std::size_t below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

}  // namespace

void check_truth(const GroundTruth& truth) {
  if (truth.source.size() != truth.target.size())
    throw InvalidInput(fmt::format("the ground truth has {} points on the source, {} on the target",
                                   truth.source.size(), truth.target.size()));
}

int surface_place(const Surface& surface, int input_vertex) {
  return input_vertex == kNoVertex ? kNoVertex : surface_vertex(surface, input_vertex);
}

std::span<const Match> matches_of(const Correspondence& matches, int source) {
  const auto [first, last] = std::ranges::equal_range(matches, source, {}, &Match::source);
  return {first, last};
}

std::vector<double> distances(const MetricSurface& target, const std::vector<ErrorPair>& pairs,
                              const Context& context) {
  return all_distances(target, pairs, context);
}

std::vector<double> distances(const MetricSurface& target, const std::vector<PointPair>& pairs,
                              const Context& context) {
  return all_distances(target, pairs, context);
}

std::vector<double> distances(const MetricSurface& target, const std::vector<TwoPoints>& pairs,
                              const Context& context) {
  return all_distances(target, pairs, context);
}

ErrorStatistics error_statistics(std::vector<double> errors, double unit) {
  if (errors.empty()) return {};
  for (double& error : errors) error /= unit;
  std::ranges::sort(errors);
  const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
  ErrorStatistics result{static_cast<int>(errors.size()),
                         sum / static_cast<double>(errors.size()),
                         percentile(errors, 0.5),
                         percentile(errors, 0.95),
                         errors.back(),
                         {}};
  result.errors = std::move(errors);
  return result;
}

std::vector<double> VertexMeans::means() const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> means(sum_.size(), kNone);
  for (std::size_t v = 0; v < means.size(); ++v)
    if (count_[v] > 0) means[v] = sum_[v] / count_[v];
  return at_input(source_, means, kNone);
}

}  // namespace isomatch
