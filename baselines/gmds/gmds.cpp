// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "gmds/gmds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gmds/coarse_start.h"
#include "gmds/stress.h"
#include "isomatch/error.h"

namespace isomatch::baselines {
namespace {

/// Evenly spread vertices, the first of which is at an end of the surface.
std::vector<int> spread_vertices(const MetricSurface& shape, int count) {
  std::vector<int> vertices(shape.num_vertices());
  std::iota(vertices.begin(), vertices.end(), 0);
  const std::vector<int> two = farthest_points(shape.graph(), vertices, 2);
  return farthest_points(shape.graph(), vertices, count, two.back());
}

/// Distances between `vertices`, relative to the largest geodesic.
Eigen::MatrixXd distances_between(const MetricSurface& shape, const std::vector<int>& vertices,
                                  const Context& context) {
  const std::vector<float> fields = geodesic_fields(shape.graph(), vertices, context);
  const Eigen::Index n = std::ssize(vertices);
  Eigen::MatrixXd distances(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j)
      distances(i, j) = fields[i * shape.num_vertices() + vertices[j]] / shape.max_geodesic();
  }
  return (distances + distances.transpose()) / 2;
}

/// Moves the points in turn until that lowers their stress no more.
void optimise(const Stress& stress, SurfaceMap& points, const GmdsOptions& options,
              const Context& context) {
  double last = stress.total(points);
  for (int sweep = 0; sweep < options.max_sweeps; ++sweep) {
    context.check_stop();
    for (int i = 0; i < std::ssize(points); ++i) stress.improve(points, i);
    const double now = stress.total(points);
    if (now > (1 - options.tolerance) * last) return;
    last = now;
  }
}

/// Adds points up to `count`, each where it fits those before it best, then optimises all.
void refine(const Stress& stress, int count, SurfaceMap& points, const GmdsOptions& options,
            const Context& context) {
  while (std::ssize(points) < count) {
    points.emplace_back();
    points.back() = stress.best_vertex(points, static_cast<int>(points.size()) - 1);
  }
  optimise(stress, points, options, context);
}

/// The least stressed of several optimised starts, after one refinement.
SurfaceMap best_start(const MetricSurface& target, const Stress& stress,
                      const Eigen::MatrixXd& wanted, const GmdsOptions& options,
                      const Context& context) {
  const std::vector<int> candidates = spread_vertices(target, options.start_candidates);
  const auto assignments = coarse_assignments(wanted, options.coarsest_points,
                                              distances_between(target, candidates, context),
                                              options.beam, options.starts);
  SurfaceMap best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<int>& assignment : assignments) {
    SurfaceMap points;
    for (int place : assignment) points.push_back(stress.at_vertex(candidates[place]));
    optimise(stress, points, options, context);
    refine(stress, std::min(2 * options.coarsest_points, options.points), points, options, context);
    const double total = stress.total(points);
    if (total >= least) continue;
    least = total;
    best = std::move(points);
  }
  return best;
}

}  // namespace

void GmdsOptions::validate() const {
  if (coarsest_points < 2 || points < coarsest_points)
    throw InvalidInput("coarsest_points must be at least 2, points at least as many");
  if (start_candidates < coarsest_points)
    throw InvalidInput("start_candidates must be at least coarsest_points");
  if (beam < 1 || starts < 1) throw InvalidInput("beam and starts must be at least 1");
  if (max_sweeps < 1 || !(tolerance > 0))
    throw InvalidInput("max_sweeps must be at least 1, tolerance positive");
}

GmdsResult match_gmds(const MetricSurface& source, const MetricSurface& target,
                      const GmdsOptions& options, const Context& context) {
  options.validate();
  if (target.num_vertices() > options.max_target_vertices)
    throw InvalidInput(fmt::format(
        "gmds keeps all distances of the target: {} vertices are too many", target.num_vertices()));
  if (std::min(source.num_vertices(), target.num_vertices()) <
      std::max(options.points, options.start_candidates))
    throw InvalidInput(fmt::format("gmds needs surfaces of at least {} vertices",
                                   std::max(options.points, options.start_candidates)));
  GmdsResult result;
  result.source_vertices = spread_vertices(source, options.points);
  const Eigen::MatrixXd wanted = distances_between(source, result.source_vertices, context);
  const DistanceTable distances = [&] {
    const StageTimer timer(result.times, "geodesics");
    return DistanceTable(target, context);
  }();
  const Stress stress(target, distances, wanted);
  {
    const StageTimer timer(result.times, "coarse start");
    result.points = best_start(target, stress, wanted, options, context);
  }
  const StageTimer timer(result.times, "refinement");
  while (std::ssize(result.points) < options.points)
    refine(stress, std::min(2 * static_cast<int>(result.points.size()), options.points),
           result.points, options, context);
  const double pairs = 0.5 * options.points * (options.points - 1);
  result.stress = std::sqrt(stress.total(result.points) / pairs);
  return result;
}

}  // namespace isomatch::baselines
