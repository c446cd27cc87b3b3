// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/measures.h"

#include <cmath>
#include <limits>

#include "geometry/kd_tree.h"
#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "isomatch/mesh/topology.h"
#include "results/loaded_mesh.h"

namespace isomatch::results {
namespace {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

std::vector<double> d_iso_of_levels(const MatchResult& result, const ResultLevel& last) {
  std::vector<double> d_iso(result.source.vertices.size(), kNotMeasured);
  for (std::size_t m = 0; m < last.many_to_one.matches.size(); ++m)
    d_iso[last.many_to_one.matches[m].source] = last.many_to_one.distortion[m];
  return d_iso;
}

std::vector<double> measured_d_iso(const Shapes& shapes, const VertexMap& map,
                                   const Context& context) {
  const Correspondence matches = to_correspondence(map);
  const IsometricDistortion distortion =
      isometric_distortion(shapes.source, shapes.target, matches, {.list_size = 100}, context);
  std::vector<double> d_iso(map.size(), kNotMeasured);
  for (std::size_t m = 0; m < matches.size(); ++m)
    d_iso[matches[m].source] = distortion.per_match[m];
  return d_iso;
}

/// At most `kMaxErrorSamples` points of a truth, evenly spaced in its order.
GroundTruth load_truth(const Shapes& shapes, const TruthFiles& files) {
  const TruthVertices given =
      read_truth(files, {shapes.source.num_vertices(), shapes.target.num_vertices()});
  const GroundTruth all = on_surfaces(shapes.source, shapes.target, {given.source, given.target});
  if (all.size() <= kMaxErrorSamples) return all;
  GroundTruth truth;
  for (std::size_t i = 0; i < kMaxErrorSamples; ++i) {
    const std::size_t point = i * all.source.size() / kMaxErrorSamples;
    truth.source.push_back(all.source[point]);
    truth.target.push_back(all.target[point]);
  }
  return truth;
}

/// Gives matched vertices of the surface without an error that of the nearest vertex with one.
void spread(const Shape& source, const SurfaceMap& map, std::vector<double>& errors) {
  const Mesh& mesh = source.mesh();
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
    if (std::isnan(errors[v]) && map[v].face != kNoFace && source.on_surface(static_cast<int>(v)) &&
        tree.nearest(mesh.vertices[v], nearest) > 0)
      errors[v] = known[nearest[0]];
  }
}

std::vector<double> measured_error(const Shapes& shapes, const SurfaceMap& map,
                                   const GroundTruth& truth, const Context& context) {
  std::vector<double> errors = vertex_errors(shapes.source, shapes.target, truth, map, context);
  spread(shapes.source, map, errors);
  return errors;
}

}  // namespace

std::vector<MapMeasures> measure_maps(const ShownMatch& match, const TruthFiles& files,
                                      const Context& context) {
  if (files.source.empty() != files.target.empty())
    throw InvalidInput("a ground truth needs both --gt-source and --gt-target");
  const MatchResult& result = match.result;
  const bool has_truth = !files.source.empty();
  std::vector<MapMeasures> measures(result.maps.size());
  if (!match.levels.empty()) measures.front().d_iso = d_iso_of_levels(result, match.levels.back());
  if (!match.levels.empty() && !has_truth) return measures;
  const Shapes shapes = match.shapes ? *match.shapes
                                     : Shapes{shape_of(result.source_path, result.source),
                                              shape_of(result.target_path, result.target)};
  const GroundTruth truth = has_truth ? load_truth(shapes, files) : GroundTruth{};
  for (std::size_t k = 0; k < measures.size(); ++k) {
    context.report(0.1 + 0.8 * static_cast<double>(k) / static_cast<double>(measures.size()),
                   "measuring");
    if (measures[k].d_iso.empty())
      measures[k].d_iso = measured_d_iso(shapes, result.maps[k].source_to_target, context);
    if (has_truth)
      measures[k].error = measured_error(shapes, result.maps[k].points, truth, context);
  }
  return measures;
}

}  // namespace isomatch::results
