// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/evaluation.h"

#include <fmt/format.h>

#include "isomatch/error.h"
#include "isomatch/io/map_file.h"

namespace isomatch::results {
namespace {

std::optional<TruthEvaluation> evaluate_truth(const Shape& source, const Shape& target,
                                              const MeasuredMap& map,
                                              const std::vector<int>& at_source,
                                              const std::vector<int>& at_target,
                                              const TruthOptions& options, const Context& context) {
  if (at_target.empty()) return std::nullopt;
  const GroundTruth truth{at_source, at_target};
  TruthEvaluation result;
  result.points_in_files = at_source.size();
  result.points = on_surfaces(source, target, truth).size();
  result.overlap = map.points ? overlap_quality(source, target, truth, *map.points)
                              : overlap_quality(source, target, truth, map.matches);
  result.template_errors = template_errors(source, target, truth, map.matches, options, context);
  if (map.points)
    result.point_errors = point_errors(source, target, truth, *map.points, options, context);
  result.match_errors = match_errors(source, target, truth, map.matches, options, context);
  return result;
}

TrueMapEvaluation evaluate_true_map(const Shape& source, const Shape& target,
                                    const MeasuredMap& map, const TrueMap& truth,
                                    const TruthOptions& options, const Context& context) {
  const auto errors = [&](const auto& measured) {
    return overlap_errors(source, target, truth, measured, options, context);
  };
  if (!map.points)
    return {overlap_quality(source, target, truth, map.matches), errors(map.matches), {}};
  return {overlap_quality(source, target, truth, *map.points), errors(map.matches),
          errors(*map.points)};
}

Json errors_json(const ErrorStatistics& errors) {
  return {{"mean", errors.mean},
          {"median", errors.median},
          {"p95", errors.p95},
          {"maximum", errors.maximum},
          {"samples", errors.samples}};
}

Json figure_json(const std::optional<double>& figure) { return figure ? Json(*figure) : Json(); }

Json overlap_json(const OverlapQuality& overlap) {
  return {{"iou", figure_json(overlap.iou())},
          {"unmatched_precision", figure_json(overlap.unmatched_precision())},
          {"unmatched_recall", figure_json(overlap.unmatched_recall())},
          {"matched_share", overlap.matched()},
          {"truly_matched_share", overlap.truly_matched()}};
}

Json truth_json(const TrueMapEvaluation& truth) {
  Json json = {{"overlap", overlap_json(truth.overlap)},
               {"error_over_sqrt_area", errors_json(truth.match_errors.over_sqrt_area)},
               {"d_grd_over_max_geodesic", errors_json(truth.match_errors.over_max_geodesic)}};
  if (!truth.point_errors) return json;
  json["point_error_over_sqrt_area"] = errors_json(truth.point_errors->over_sqrt_area);
  json["point_d_grd_over_max_geodesic"] = errors_json(truth.point_errors->over_max_geodesic);
  return json;
}

Json truth_json(const TruthEvaluation& truth) {
  Json json = {{"template_points", truth.points_in_files},
               {"template_points_on_surfaces", truth.points},
               {"overlap", overlap_json(truth.overlap)},
               {"error_over_sqrt_area", errors_json(truth.template_errors)}};
  if (truth.point_errors) json["point_error_over_sqrt_area"] = errors_json(*truth.point_errors);
  json["d_grd_over_max_geodesic"] = errors_json(truth.match_errors);
  return json;
}

std::vector<int> read_target_truth(const std::string& file, int vertices, const TruthFiles& files,
                                   std::size_t points) {
  if (file.empty()) return {};
  std::vector<int> truth = read_ground_truth(file, vertices);
  if (truth.size() != points)
    throw BadFile(
        file, fmt::format("{} template points, but {} has {}", truth.size(), files.source, points));
  return truth;
}

}  // namespace

TruthVertices read_truth(const TruthFiles& files, VertexCounts counts) {
  if (files.target.empty()) return {};
  TruthVertices truth;
  truth.source = read_ground_truth(files.source, counts.source);
  truth.target = read_target_truth(files.target, counts.target, files, truth.source.size());
  truth.symmetric_target =
      read_target_truth(files.symmetric_target, counts.target, files, truth.source.size());
  return truth;
}

TrueMap read_true_map(const std::string& file, const Shape& source, const Shape& target) {
  const MapChecks checks{source.num_vertices(), target.num_vertices(), target.mesh().num_faces()};
  MapContent content = read_map(file, checks, Numbering::kFromZero);
  if (content.points.empty()) return std::move(content.source_to_target);
  return std::move(content.points);
}

MeasuredMap measured_map(const Shape& target, const MatchContent& content) {
  if (content.points.empty()) return {content.matches, {}};
  return {to_correspondence(nearest_vertices(target.mesh(), content.points)), content.points};
}

Evaluation evaluate(const Shape& source, const Shape& target, const MeasuredMap& map,
                    const Truth& truth, const EvaluationOptions& options, const Context& context) {
  const TruthVertices& vertices = truth.vertices;
  const auto against = [&](const std::vector<int>& at_target) {
    return evaluate_truth(source, target, map, vertices.source, at_target, options.truth, context);
  };
  Evaluation result;
  result.truth = against(vertices.target);
  result.symmetric_truth = against(vertices.symmetric_target);
  if (truth.map)
    result.true_map = evaluate_true_map(source, target, map, *truth.map, options.truth, context);
  result.coverage = target_coverage(source, target, map.matches);
  result.orientation = map_orientation(source, target, map.matches, {}, context);
  result.distortion =
      isometric_distortion(source, target, map.matches, options.distortion, context);
  return result;
}

Evaluation evaluate(const Shape& source, const Shape& target, const MeasuredMap& map,
                    const TruthFiles& files, const EvaluationOptions& options,
                    const Context& context) {
  const VertexCounts counts{source.num_vertices(), target.num_vertices()};
  Truth truth{read_truth(files, counts), std::nullopt};
  if (!files.map.empty()) truth.map = read_true_map(files.map, source, target);
  return evaluate(source, target, map, truth, options, context);
}

Json to_json(const Evaluation& evaluation) {
  Json json = {{"matches", evaluation.distortion.matches},
               {"d_iso_over_max_geodesic",
                {{"mean", evaluation.distortion.mean}, {"maximum", evaluation.distortion.maximum}}},
               {"target_hit",
                {{"vertices", evaluation.coverage.vertices}, {"area", evaluation.coverage.area}}},
               {"orientation",
                {{"verdict", to_string(evaluation.orientation.verdict)},
                 {"preserved_share", evaluation.orientation.preserved_share},
                 {"mean_sign", evaluation.orientation.mean_sign},
                 {"votes", evaluation.orientation.votes}}}};
  if (evaluation.truth) json["ground_truth"] = truth_json(*evaluation.truth);
  if (evaluation.symmetric_truth) {
    json["symmetric_ground_truth"] = truth_json(*evaluation.symmetric_truth);
    json["flipped"] = evaluation.flipped();
  }
  if (evaluation.true_map) json["ground_truth_map"] = truth_json(*evaluation.true_map);
  if (evaluation.registered)
    json["registered"] = {{"folded", evaluation.registered->folded},
                          {"squeezed", evaluation.registered->squeezed},
                          {"reach", evaluation.registered->reach}};
  return json;
}

}  // namespace isomatch::results
