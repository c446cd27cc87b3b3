// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "command.h"
#include "isomatch/error.h"
#include "isomatch/map_io.h"
#include "isomatch/mesh_io.h"
#include "isomatch/metrics.h"
#include "json.h"
#include "load.h"

namespace isomatch::cli {
namespace {

struct EvalArguments {
  std::string source, target, map;
  std::string source_truth, target_truth, target_symmetric_truth;
  bool one_based = false;
  bool json = false;
  TruthOptions truth;
  DistortionOptions distortion;
};

/// Errors against one ground truth.
struct TruthEvaluation {
  /// Template points in the files, and those that lie on both surfaces.
  std::size_t points_in_files = 0;
  int points = 0;
  ErrorStatistics template_errors;
  /// Of a map to points on triangles.
  std::optional<ErrorStatistics> point_errors;
  ErrorStatistics match_errors;
};

struct Evaluation {
  int matches = 0;
  IsometricDistortion distortion;
  Coverage coverage;
  MapOrientation orientation;
  std::optional<TruthEvaluation> truth;
  std::optional<TruthEvaluation> symmetric_truth;

  bool flipped() const {
    return symmetric_truth && symmetric_truth->template_errors.mean < truth->template_errors.mean;
  }
};

struct EvalInputs {
  Shape source, target;
  /// Of the target's file.
  int target_faces;
  Correspondence matches;
  /// In the numbers of the surfaces, if the map leads to points on triangles.
  std::optional<SurfaceMap> points;
};

int input_vertices(const Shape& shape) {
  return static_cast<int>(shape.surface.surface_vertex.size());
}

void read_map(const EvalArguments& arguments, EvalInputs& inputs) {
  const VertexCounts counts{input_vertices(inputs.source), input_vertices(inputs.target)};
  const Numbering numbering = arguments.one_based ? Numbering::kFromOne : Numbering::kFromZero;
  const Surface& source = inputs.source.surface;
  const Surface& target = inputs.target.surface;
  if (arguments.map.ends_with(".bary.txt")) {
    inputs.points = surface_map(
        source, target,
        read_surface_map(arguments.map, {counts.source, inputs.target_faces}, numbering));
    inputs.matches = to_correspondence(nearest_vertices(target.mesh, *inputs.points));
  } else {
    inputs.matches =
        surface_matches(source, target, read_correspondence(arguments.map, counts, numbering));
  }
}

EvalInputs load_inputs(const EvalArguments& arguments, const Context& context) {
  Shape source = load_shape(arguments.source, context);
  const Mesh target_mesh = read_mesh(arguments.target);
  Shape target = prepare_loaded(arguments.target, target_mesh, {}, context);
  EvalInputs inputs{std::move(source), std::move(target), target_mesh.num_faces(), {}, {}};
  read_map(arguments, inputs);
  return inputs;
}

std::optional<TruthEvaluation> evaluate_truth(const EvalArguments& arguments,
                                              const std::string& target_file,
                                              const EvalInputs& inputs, const Context& context) {
  if (target_file.empty()) return std::nullopt;
  const auto& [source, target, target_faces, matches, points] = inputs;
  const std::vector<int> at_source = read_vts(arguments.source_truth, input_vertices(source));
  const std::vector<int> at_target = read_vts(target_file, input_vertices(target));
  if (at_source.size() != at_target.size())
    throw BadFile(target_file, fmt::format("{} template points, but {} has {}", at_target.size(),
                                           arguments.source_truth, at_source.size()));
  const GroundTruth truth = surface_truth(source.surface, target.surface, at_source, at_target);
  TruthEvaluation result{at_source.size(), truth.size(), {}, {}, {}};
  result.template_errors = template_errors(target, truth, matches, arguments.truth, context);
  if (points) result.point_errors = point_errors(target, truth, *points, arguments.truth, context);
  result.match_errors = match_errors(target, truth, matches, arguments.truth, context);
  return result;
}

Evaluation evaluate(const EvalArguments& arguments, const Context& context) {
  const EvalInputs inputs = load_inputs(arguments, context);
  const auto& [source, target, target_faces, matches, points] = inputs;
  const auto against = [&](const std::string& target_file) {
    return evaluate_truth(arguments, target_file, inputs, context);
  };
  Evaluation result;
  result.matches = static_cast<int>(matches.size());
  result.truth = against(arguments.target_truth);
  result.symmetric_truth = against(arguments.target_symmetric_truth);
  result.coverage = target_coverage(target, matches);
  result.orientation = map_orientation(source, target, matches, {}, context);
  result.distortion = isometric_distortion(source, target, matches, arguments.distortion, context);
  return result;
}

Json to_json(const ErrorStatistics& errors) {
  return {{"mean", errors.mean},
          {"median", errors.median},
          {"p95", errors.p95},
          {"maximum", errors.maximum},
          {"samples", errors.samples}};
}

Json to_json(const TruthEvaluation& truth) {
  Json json = {{"template_points", truth.points_in_files},
               {"template_points_on_surfaces", truth.points},
               {"error_over_sqrt_area", to_json(truth.template_errors)}};
  if (truth.point_errors) json["point_error_over_sqrt_area"] = to_json(*truth.point_errors);
  json["d_grd_over_max_geodesic"] = to_json(truth.match_errors);
  return json;
}

Json to_json(const Evaluation& evaluation) {
  Json json = {{"matches", evaluation.matches},
               {"d_iso_over_max_geodesic",
                {{"mean", evaluation.distortion.mean}, {"maximum", evaluation.distortion.maximum}}},
               {"target_hit",
                {{"vertices", evaluation.coverage.vertices}, {"area", evaluation.coverage.area}}},
               {"orientation",
                {{"verdict", to_string(evaluation.orientation.verdict)},
                 {"preserved_share", evaluation.orientation.preserved_share},
                 {"mean_sign", evaluation.orientation.mean_sign},
                 {"votes", evaluation.orientation.votes}}}};
  if (evaluation.truth) json["ground_truth"] = to_json(*evaluation.truth);
  if (evaluation.symmetric_truth) {
    json["symmetric_ground_truth"] = to_json(*evaluation.symmetric_truth);
    json["flipped"] = evaluation.flipped();
  }
  return json;
}

void print_errors(std::string_view name, const ErrorStatistics& error) {
  fmt::print("  {:<32}mean {:.4f}  median {:.4f}  p95 {:.4f}  max {:.4f}\n", name, error.mean,
             error.median, error.p95, error.maximum);
}

void print(std::string_view name, const TruthEvaluation& truth) {
  const ErrorStatistics& grd = truth.match_errors;
  fmt::print("{}, {} of {} template points on both surfaces\n", name, truth.points,
             truth.points_in_files);
  print_errors("error / sqrt(area of target)", truth.template_errors);
  if (truth.point_errors) print_errors("the same of points on triangles", *truth.point_errors);
  fmt::print("  D_grd / maximum geodesic        mean {:.4f}  maximum (d_grd-dagger) {:.4f}\n",
             grd.mean, grd.maximum);
}

void print(const Evaluation& evaluation) {
  const MapOrientation& orientation = evaluation.orientation;
  fmt::print("{} matches\n", evaluation.matches);
  fmt::print("  D_iso / maximum geodesic        mean {:.4f}  maximum (d_iso-dagger) {:.4f}\n",
             evaluation.distortion.mean, evaluation.distortion.maximum);
  fmt::print("  target hit                      {:.1f} % of vertices, {:.1f} % of area\n",
             100 * evaluation.coverage.vertices, 100 * evaluation.coverage.area);
  fmt::print("  orientation                     {}: preserved around {:.0f} % of {} landmarks\n",
             to_string(orientation.verdict), 100 * orientation.preserved_share, orientation.votes);
  if (evaluation.truth) print("against the ground truth", *evaluation.truth);
  if (!evaluation.symmetric_truth) return;
  print("against the symmetric ground truth", *evaluation.symmetric_truth);
  fmt::print("  symmetric flip                  {}\n", evaluation.flipped() ? "yes" : "no");
}

void run_eval(const EvalArguments& arguments, const Context& context) {
  const Evaluation evaluation = evaluate(arguments, context);
  if (arguments.json)
    fmt::print("{}\n", to_json(evaluation).dump(2));
  else
    print(evaluation);
}

void add_files(CLI::App& command, EvalArguments& arguments) {
  command.add_option("SOURCE", arguments.source, "Mesh that the map starts from")->required();
  command.add_option("TARGET", arguments.target, "Mesh that the map leads to")->required();
  command
      .add_option("MAP", arguments.map,
                  "Target vertex of each source vertex, one a line; or source and target vertex a "
                  "line; or, in a file named .bary.txt, target face and three weights of each "
                  "source vertex")
      ->required();
  auto* source_truth =
      command.add_option("--gt-source", arguments.source_truth, "Ground truth on the source")
          ->type_name("VTS");
  auto* target_truth =
      command.add_option("--gt-target", arguments.target_truth, "Ground truth on the target")
          ->type_name("VTS")
          ->needs(source_truth);
  source_truth->needs(target_truth);
  command
      .add_option("--gt-target-sym", arguments.target_symmetric_truth,
                  "Ground truth on the target under the left-right symmetry")
      ->type_name("VTS")
      ->needs(target_truth);
}

}  // namespace

void add_eval(CLI::App& app, Request& request) {
  const auto arguments = std::make_shared<EvalArguments>();
  CLI::App& command = *app.add_subcommand("eval", "Measure the quality of a map");
  add_files(command, *arguments);
  command.add_flag("--one-based", arguments->one_based, "MAP numbers vertices and faces from one");
  command
      .add_option("--samples", arguments->truth.max_samples,
                  "Most ground-truth errors to compute, evenly spaced")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      .add_option("--list", arguments->distortion.list_size,
                  "Matches that distortion is measured against (E)")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_flag("--json", arguments->json, "Print JSON");
  add_run_options(command, request);
  set_example(command,
              "isomatch eval cat0.off cat1.off result/source_to_target.txt --gt-source cat0.vts "
              "--gt-target cat1.vts --gt-target-sym cat1.sym.vts");
  command.callback([arguments, &request] {
    request.action = [arguments](const Context& context) { run_eval(*arguments, context); };
  });
}

}  // namespace isomatch::cli
