// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "vertex_errors.h"

#include <algorithm>
#include <limits>

#include "isomatch/mesh/topology.h"

namespace isomatch::python {
namespace {

/// The points of the target at which each source vertex has a match.
std::vector<SurfaceMap> images(const Surface& source, const Surface& target,
                               const results::MeasuredMap& map) {
  std::vector<SurfaceMap> result(source.num_vertices());
  if (map.points) {
    for (std::size_t v = 0; v < result.size(); ++v) {
      const SurfacePoint& point = (*map.points)[v];
      if (point.face != kNoFace) result[v].push_back(point);
    }
    return result;
  }
  const SurfaceMap corners = corner_points(target.mesh);
  for (const Match& match : map.matches) result[match.source].push_back(corners[match.target]);
  return result;
}

}  // namespace

std::vector<double> vertex_errors(const PreparedMesh& source, const PreparedMesh& target,
                                  const results::MeasuredMap& map, std::span<const int> at_source,
                                  std::span<const int> at_target, const Context& context) {
  const GroundTruth truth = surface_truth(source.surface(), target.surface(), at_source, at_target);
  const std::vector<SurfaceMap> points = images(source.surface(), target.surface(), map);
  // Every pair of a template point and a match, as a map of its own.
  GroundTruth pairs;
  SurfaceMap mapped;
  std::vector<int> vertex;
  for (int i = 0; i < truth.size(); ++i) {
    for (const SurfacePoint& point : points[truth.source[i]]) {
      pairs.source.push_back(static_cast<int>(mapped.size()));
      pairs.target.push_back(truth.target[i]);
      mapped.push_back(point);
      vertex.push_back(truth.source[i]);
    }
  }
  const std::vector<double> errors =
      point_error_list(target.shape(context), pairs, mapped, context);
  std::vector<double> sum(points.size(), 0.0), count(points.size(), 0.0);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    sum[vertex[i]] += errors[i];
    ++count[vertex[i]];
  }
  std::ranges::transform(sum, count, sum.begin(), [](double s, double n) {
    return n > 0 ? s / n : std::numeric_limits<double>::quiet_NaN();
  });
  return input_values(source.surface(), sum);
}

}  // namespace isomatch::python
