// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "isomatch/mesh/topology.h"
#include "measure/checks.h"
#include "parallel.h"

namespace isomatch {
namespace {

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

/// The matches of each source vertex lie together in a sorted correspondence.
std::span<const Match> matches_of(const Correspondence& matches, int source) {
  const auto [first, last] = std::ranges::equal_range(matches, source, {}, &Match::source);
  return {first, last};
}

std::vector<ErrorPair> template_pairs(const GroundTruth& truth, const Correspondence& matches) {
  std::vector<ErrorPair> pairs;
  for (int i = 0; i < truth.size(); ++i) {
    for (const Match& match : matches_of(matches, truth.source[i]))
      pairs.push_back({truth.target[i], match.target});
  }
  return pairs;
}

std::vector<ErrorPair> match_pairs(const GroundTruth& truth, const Correspondence& matches) {
  std::vector<int> order(truth.size());
  std::iota(order.begin(), order.end(), 0);
  const auto source_of = [&](int i) { return truth.source[i]; };
  std::ranges::stable_sort(order, {}, source_of);
  std::vector<ErrorPair> pairs;
  for (const Match& match : matches) {
    const auto point = std::ranges::lower_bound(order, match.source, {}, source_of);
    if (point != order.end() && source_of(*point) == match.source)
      pairs.push_back({truth.target[*point], match.target});
  }
  return pairs;
}

std::vector<PointPair> point_pairs(const GroundTruth& truth, const SurfaceMap& map) {
  std::vector<PointPair> pairs;
  for (int i = 0; i < truth.size(); ++i) {
    const SurfacePoint& point = map[truth.source[i]];
    if (point.face != kNoFace) pairs.push_back({truth.target[i], point});
  }
  return pairs;
}

template <class Pair>
std::vector<Pair> evenly_thinned(const std::vector<Pair>& pairs, int max_samples) {
  if (std::ssize(pairs) <= max_samples) return pairs;
  std::vector<Pair> thinned(max_samples);
  for (std::size_t i = 0; i < thinned.size(); ++i)
    thinned[i] = pairs[i * pairs.size() / thinned.size()];
  return thinned;
}

double distance(const Shape&, GeodesicSearch& search, const ErrorPair& pair) {
  return search.distance(pair.truth, pair.mapped);
}

double distance(const Shape& shape, GeodesicSearch& search, const PointPair& pair) {
  const Mesh& mesh = shape.surface.mesh;
  const Point x = position(mesh, pair.mapped);
  double squared = 0;
  for (int k = 0; k < 3; ++k) {
    const double weight = pair.mapped.weights[k];
    if (weight == 0) continue;
    const int corner = mesh.faces[pair.mapped.face][k];
    const double to_corner = search.distance(pair.truth, corner);
    squared += weight * (to_corner * to_corner - (mesh.vertices[corner] - x).squaredNorm());
  }
  return std::sqrt(std::max(0.0, squared));
}

template <class Pair>
std::vector<double> distances(const Shape& shape, const std::vector<Pair>& pairs,
                              const Context& context) {
  std::vector<double> result(pairs.size(), 0.0);
  parallel_for(
      std::ssize(pairs), context, [&] { return GeodesicSearch(shape.graph); },
      [&](GeodesicSearch& search, std::ptrdiff_t i) {
        result[i] = distance(shape, search, pairs[i]);
      });
  return result;
}

double percentile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const std::size_t below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

ErrorStatistics statistics(std::vector<double> errors, double unit) {
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

void check_truth(const Shape& target, const GroundTruth& truth) {
  if (truth.source.size() != truth.target.size())
    throw InvalidInput("a ground truth needs as many source as target vertices");
  for (int v : truth.target) check_vertex(target, v);
}

void check_points(const Shape& target, const GroundTruth& truth, const SurfaceMap& map) {
  for (int v : truth.source) check_index(v, map.size());
  for (const SurfacePoint& point : map) {
    if (point.face < kNoFace || point.face >= target.surface.mesh.num_faces())
      throw InvalidInput(fmt::format("face {} is out of range", point.face));
  }
}

}  // namespace

void TruthOptions::validate() const {
  if (max_samples < 1) throw InvalidInput("max_samples must be at least 1");
}

ErrorStatistics template_errors(const Shape& target, const GroundTruth& truth,
                                const Correspondence& matches, const TruthOptions& options,
                                const Context& context) {
  options.validate();
  check_truth(target, truth);
  check_targets(target, matches);
  const auto pairs = evenly_thinned(template_pairs(truth, matches), options.max_samples);
  return statistics(distances(target, pairs, context), std::sqrt(target.surface.area));
}

ErrorStatistics point_errors(const Shape& target, const GroundTruth& truth, const SurfaceMap& map,
                             const TruthOptions& options, const Context& context) {
  options.validate();
  check_truth(target, truth);
  check_points(target, truth, map);
  const auto pairs = evenly_thinned(point_pairs(truth, map), options.max_samples);
  return statistics(distances(target, pairs, context), std::sqrt(target.surface.area));
}

std::vector<double> point_error_list(const Shape& target, const GroundTruth& truth,
                                     const SurfaceMap& map, const Context& context) {
  check_truth(target, truth);
  check_points(target, truth, map);
  const std::vector<double> measured = distances(target, point_pairs(truth, map), context);
  std::vector<double> errors;
  for (int i = 0, next = 0; i < truth.size(); ++i) {
    const bool has_point = map[truth.source[i]].face != kNoFace;
    errors.push_back(has_point ? measured[next++] / std::sqrt(target.surface.area)
                               : std::numeric_limits<double>::quiet_NaN());
  }
  return errors;
}

ErrorStatistics match_errors(const Shape& target, const GroundTruth& truth,
                             const Correspondence& matches, const TruthOptions& options,
                             const Context& context) {
  options.validate();
  check_truth(target, truth);
  check_targets(target, matches);
  const auto pairs = evenly_thinned(match_pairs(truth, matches), options.max_samples);
  return statistics(distances(target, pairs, context), target.max_geodesic);
}

}  // namespace isomatch
