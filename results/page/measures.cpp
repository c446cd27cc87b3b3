// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/measures.h"

#include <cmath>
#include <limits>

#include "geometry/kd_tree.h"
#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "load.h"

namespace isomatch::cli {
namespace {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

struct Shapes {
  Shape source, target;
};

/// Values of surface vertices as values of the vertices of the file.
std::vector<double> at_input(const Surface& surface, const std::vector<double>& values) {
  std::vector<double> result;
  for (int v : surface.surface_vertex) result.push_back(v == kNoVertex ? kNotMeasured : values[v]);
  return result;
}

std::vector<double> d_iso_of_levels(const MatchResult& result, const ResultLevel& last) {
  std::vector<double> d_iso(result.source.vertices.size(), kNotMeasured);
  for (std::size_t m = 0; m < last.many_to_one.matches.size(); ++m)
    d_iso[last.many_to_one.matches[m].source] = last.many_to_one.distortion[m];
  return d_iso;
}

std::vector<double> measured_d_iso(const Shapes& shapes, const SurfaceMap& map,
                                   const Context& context) {
  const Correspondence matches =
      to_correspondence(nearest_vertices(shapes.target.surface.mesh, map));
  const IsometricDistortion distortion =
      isometric_distortion(shapes.source, shapes.target, matches, {.list_size = 100}, context);
  std::vector<double> d_iso(map.size(), kNotMeasured);
  for (std::size_t m = 0; m < matches.size(); ++m)
    d_iso[matches[m].source] = distortion.per_match[m];
  return at_input(shapes.source.surface, d_iso);
}

/// At most `kMaxErrorSamples` points of a truth, evenly spaced in its order.
GroundTruth load_truth(const MatchResult& result, const Shapes& shapes, const TruthFiles& files) {
  const TruthVertices given =
      read_truth(files, {result.source.num_vertices(), result.target.num_vertices()});
  const GroundTruth all =
      surface_truth(shapes.source.surface, shapes.target.surface, given.source, given.target);
  if (all.size() <= kMaxErrorSamples) return all;
  GroundTruth truth;
  for (std::size_t i = 0; i < kMaxErrorSamples; ++i) {
    const std::size_t point = i * all.source.size() / kMaxErrorSamples;
    truth.source.push_back(all.source[point]);
    truth.target.push_back(all.target[point]);
  }
  return truth;
}

/// Gives vertices without an error that of the nearest vertex with one.
void spread(const Mesh& mesh, std::vector<double>& errors) {
  std::vector<Point> places;
  std::vector<double> known;
  for (std::size_t v = 0; v < errors.size(); ++v) {
    if (std::isnan(errors[v])) continue;
    places.push_back(mesh.vertices[v]);
    known.push_back(errors[v]);
  }
  if (known.empty()) return;
  const KdTree<3> tree(places);
  for (std::size_t v = 0; v < errors.size(); ++v) {
    std::array<int, 1> nearest{};
    if (std::isnan(errors[v]) && tree.nearest(mesh.vertices[v], nearest) > 0)
      errors[v] = known[nearest[0]];
  }
}

std::vector<double> measured_error(const Shapes& shapes, const SurfaceMap& map,
                                   const GroundTruth& truth, const Context& context) {
  const Mesh& mesh = shapes.source.surface.mesh;
  const std::vector<double> list = point_error_list(shapes.target, truth, map, context);
  std::vector<double> errors(mesh.vertices.size(), kNotMeasured);
  for (int i = 0; i < truth.size(); ++i) errors[truth.source[i]] = list[i];
  spread(mesh, errors);
  return at_input(shapes.source.surface, errors);
}

}  // namespace

std::vector<MapMeasures> measure_maps(const MatchResult& result,
                                      const std::vector<ResultLevel>& levels,
                                      const TruthFiles& files, const Context& context) {
  if (files.source.empty() != files.target.empty())
    throw InvalidInput("a ground truth needs both --gt-source and --gt-target");
  const bool has_truth = !files.source.empty();
  std::vector<MapMeasures> measures(result.maps.size());
  if (!levels.empty()) measures.front().d_iso = d_iso_of_levels(result, levels.back());
  if (!levels.empty() && !has_truth) return measures;
  const Shapes shapes{prepare_loaded(result.source_path, result.source, context),
                      prepare_loaded(result.target_path, result.target, context)};
  const GroundTruth truth = has_truth ? load_truth(result, shapes, files) : GroundTruth{};
  for (std::size_t k = 0; k < measures.size(); ++k) {
    context.report(0.1 + 0.8 * static_cast<double>(k) / static_cast<double>(measures.size()),
                   "measuring");
    const SurfaceMap map =
        surface_map(shapes.source.surface, shapes.target.surface, result.maps[k].points);
    if (measures[k].d_iso.empty()) measures[k].d_iso = measured_d_iso(shapes, map, context);
    if (has_truth) measures[k].error = measured_error(shapes, map, truth, context);
  }
  return measures;
}

}  // namespace isomatch::cli
