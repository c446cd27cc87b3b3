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
#include "parallel.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"

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

using SurfaceTruth = OnSurface<GroundTruth>;

void check_lengths(const GroundTruth& truth) {
  if (truth.source.size() != truth.target.size())
    throw InvalidInput(fmt::format("the ground truth has {} points on the source, {} on the target",
                                   truth.source.size(), truth.target.size()));
}

/// Without template points that are off either surface.
SurfaceTruth on_surfaces(const Surface& source, const Surface& target, const GroundTruth& truth) {
  check_lengths(truth);
  GroundTruth result;
  for (int i = 0; i < truth.size(); ++i) {
    const int s = surface_vertex(source, truth.source[i]);
    const int t = surface_vertex(target, truth.target[i]);
    if (s == kNoVertex || t == kNoVertex) continue;
    result.source.push_back(s);
    result.target.push_back(t);
  }
  return SurfaceTruth(std::move(result));
}

/// The matches of each source vertex lie together in a sorted correspondence.
std::span<const Match> matches_of(const Correspondence& matches, int source) {
  const auto [first, last] = std::ranges::equal_range(matches, source, {}, &Match::source);
  return {first, last};
}

std::vector<ErrorPair> template_pairs(const SurfaceTruth& truth, const SurfaceMatches& matches) {
  std::vector<ErrorPair> pairs;
  for (int i = 0; i < truth->size(); ++i) {
    for (const Match& match : matches_of(*matches, truth->source[i]))
      pairs.push_back({truth->target[i], match.target});
  }
  return pairs;
}

std::vector<ErrorPair> match_pairs(const SurfaceTruth& truth, const SurfaceMatches& matches) {
  std::vector<int> order(truth->size());
  std::iota(order.begin(), order.end(), 0);
  const auto source_of = [&](int i) { return truth->source[i]; };
  std::ranges::stable_sort(order, {}, source_of);
  std::vector<ErrorPair> pairs;
  for (const Match& match : *matches) {
    const auto point = std::ranges::lower_bound(order, match.source, {}, source_of);
    if (point != order.end() && source_of(*point) == match.source)
      pairs.push_back({truth->target[*point], match.target});
  }
  return pairs;
}

std::vector<PointPair> point_pairs(const SurfaceTruth& truth, const SurfacePoints& map) {
  std::vector<PointPair> pairs;
  for (int i = 0; i < truth->size(); ++i) {
    const SurfacePoint& point = (*map)[truth->source[i]];
    if (point.face != kNoFace) pairs.push_back({truth->target[i], point});
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

double distance(const Surface&, GeodesicSearch& search, const ErrorPair& pair) {
  return search.distance(pair.truth, pair.mapped);
}

double distance(const Surface& surface, GeodesicSearch& search, const PointPair& pair) {
  const Mesh& mesh = surface.mesh;
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
std::vector<double> distances(const MetricSurface& target, const std::vector<Pair>& pairs,
                              const Context& context) {
  std::vector<double> result(pairs.size(), 0.0);
  parallel_for(
      std::ssize(pairs), context, [&] { return GeodesicSearch(target.graph()); },
      [&](GeodesicSearch& search, std::ptrdiff_t i) {
        result[i] = distance(target.surface(), search, pairs[i]);
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

/// Both shapes and a truth, ready to measure.
struct Ground {
  Ground(const Shape& source_shape, const Shape& target_shape, const GroundTruth& given,
         const Context& context)
      : source(*source_shape.prepared().surface()),
        target(target_shape.prepared().metric(context)),
        truth(on_surfaces(source, target.surface(), given)) {}

  const Surface& source;
  MetricSurface target;
  SurfaceTruth truth;
};

/// The mean of what is measured at each vertex of the caller's.
class VertexMeans {
 public:
  explicit VertexMeans(const Surface& source)
      : source_(source), sum_(source.num_vertices(), 0.0), count_(sum_) {}

  void add(int vertex, double value) {
    sum_[vertex] += value;
    ++count_[vertex];
  }
  std::vector<double> means() const {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> means(sum_.size(), kNone);
    for (std::size_t v = 0; v < means.size(); ++v)
      if (count_[v] > 0) means[v] = sum_[v] / count_[v];
    return at_input(source_, means, kNone);
  }

 private:
  const Surface& source_;
  std::vector<double> sum_, count_;
};

}  // namespace

void TruthOptions::validate() const {
  if (max_samples < 1) throw InvalidInput("max_samples must be at least 1");
}

GroundTruth on_surfaces(const Shape& source, const Shape& target, const GroundTruth& truth) {
  check_lengths(truth);
  const Surface& from = *source.prepared().surface();
  const Surface& onto = *target.prepared().surface();
  GroundTruth kept;
  for (int i = 0; i < truth.size(); ++i) {
    if (surface_vertex(from, truth.source[i]) == kNoVertex) continue;
    if (surface_vertex(onto, truth.target[i]) == kNoVertex) continue;
    kept.source.push_back(truth.source[i]);
    kept.target.push_back(truth.target[i]);
  }
  return kept;
}

ErrorStatistics template_errors(const Shape& source, const Shape& target, const GroundTruth& truth,
                                const Correspondence& matches, const TruthOptions& options,
                                const Context& context) {
  options.validate();
  const Ground ground(source, target, truth, context);
  const SurfaceMatches between = on_surfaces(ground.source, ground.target.surface(), matches);
  const auto pairs = evenly_thinned(template_pairs(ground.truth, between), options.max_samples);
  return statistics(distances(ground.target, pairs, context), 1);
}

ErrorStatistics point_errors(const Shape& source, const Shape& target, const GroundTruth& truth,
                             const SurfaceMap& map, const TruthOptions& options,
                             const Context& context) {
  options.validate();
  const Ground ground(source, target, truth, context);
  const SurfacePoints between = on_surfaces(ground.source, ground.target.surface(), map);
  const auto pairs = evenly_thinned(point_pairs(ground.truth, between), options.max_samples);
  return statistics(distances(ground.target, pairs, context), 1);
}

std::vector<double> vertex_errors(const Shape& source, const Shape& target,
                                  const GroundTruth& truth, const SurfaceMap& map,
                                  const Context& context) {
  const Ground ground(source, target, truth, context);
  const SurfacePoints between = on_surfaces(ground.source, ground.target.surface(), map);
  const std::vector<double> errors =
      distances(ground.target, point_pairs(ground.truth, between), context);
  VertexMeans means(ground.source);
  std::size_t next = 0;
  for (int vertex : ground.truth->source)
    if ((*between)[vertex].face != kNoFace) means.add(vertex, errors[next++]);
  return means.means();
}

std::vector<double> vertex_errors(const Shape& source, const Shape& target,
                                  const GroundTruth& truth, const Correspondence& matches,
                                  const Context& context) {
  const Ground ground(source, target, truth, context);
  const SurfaceMatches between = on_surfaces(ground.source, ground.target.surface(), matches);
  const std::vector<double> errors =
      distances(ground.target, template_pairs(ground.truth, between), context);
  VertexMeans means(ground.source);
  std::size_t next = 0;
  for (int vertex : ground.truth->source)
    for (std::size_t k = matches_of(*between, vertex).size(); k > 0; --k)
      means.add(vertex, errors[next++]);
  return means.means();
}

ErrorStatistics match_errors(const Shape& source, const Shape& target, const GroundTruth& truth,
                             const Correspondence& matches, const TruthOptions& options,
                             const Context& context) {
  options.validate();
  const Ground ground(source, target, truth, context);
  const SurfaceMatches between = on_surfaces(ground.source, ground.target.surface(), matches);
  const auto pairs = evenly_thinned(match_pairs(ground.truth, between), options.max_samples);
  return statistics(distances(ground.target, pairs, context), ground.target.max_geodesic());
}

}  // namespace isomatch
