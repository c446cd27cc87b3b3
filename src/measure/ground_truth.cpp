// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "isomatch/mesh/topology.h"
#include "measure/surface_errors.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"

namespace isomatch {
namespace {

using SurfaceTruth = OnSurface<GroundTruth>;

/// Without template points that are missing on or off either surface.
SurfaceTruth on_surfaces(const Surface& source, const Surface& target, const GroundTruth& truth) {
  check_truth(truth);
  GroundTruth result;
  for (int i = 0; i < truth.size(); ++i) {
    const int s = surface_place(source, truth.source[i]);
    const int t = surface_place(target, truth.target[i]);
    if (s == kNoVertex || t == kNoVertex) continue;
    result.source.push_back(s);
    result.target.push_back(t);
  }
  return SurfaceTruth(std::move(result));
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

}  // namespace

void TruthOptions::validate() const {
  if (max_samples < 1) throw InvalidInput("max_samples must be at least 1");
}

GroundTruth on_surfaces(const Shape& source, const Shape& target, const GroundTruth& truth) {
  check_truth(truth);
  const Surface& from = *source.prepared().surface();
  const Surface& onto = *target.prepared().surface();
  GroundTruth kept;
  for (int i = 0; i < truth.size(); ++i) {
    if (surface_place(from, truth.source[i]) == kNoVertex) continue;
    if (surface_place(onto, truth.target[i]) == kNoVertex) continue;
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
  return error_statistics(distances(ground.target, pairs, context), 1);
}

ErrorStatistics point_errors(const Shape& source, const Shape& target, const GroundTruth& truth,
                             const SurfaceMap& map, const TruthOptions& options,
                             const Context& context) {
  options.validate();
  const Ground ground(source, target, truth, context);
  const SurfacePoints between = on_surfaces(ground.source, ground.target.surface(), map);
  const auto pairs = evenly_thinned(point_pairs(ground.truth, between), options.max_samples);
  return error_statistics(distances(ground.target, pairs, context), 1);
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
  return error_statistics(distances(ground.target, pairs, context), ground.target.max_geodesic());
}

}  // namespace isomatch
