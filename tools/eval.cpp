// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "command.h"
#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "load.h"
#include "map_input.h"
#include "program/progress_bar.h"
#include "results/evaluation.h"
#include "results/loaded_mesh.h"

namespace isomatch::cli {
namespace {

struct EvalArguments {
  std::string source, target, map, registered;
  results::TruthFiles truth;
  bool one_based = false;
  bool json = false;
  results::EvaluationOptions options;
};

struct Measured {
  results::Evaluation evaluation;
  MapReadReport map;
};

/// Throws `BadFile` if there are not as many as the source has.
std::vector<Point> registered_vertices(const std::string& file, const Shape& source) {
  std::vector<Point> vertices = read_mesh(file).vertices;
  if (std::cmp_not_equal(vertices.size(), source.num_vertices()))
    throw BadFile(file, "does not have as many vertices as the source");
  return vertices;
}

Measured measure(const EvalArguments& arguments, const Context& context) {
  const Shape source = results::shape_of(arguments.source, load_mesh(arguments.source));
  const Shape target = results::shape_of(arguments.target, load_mesh(arguments.target));
  const MapChecks checks{source.num_vertices(), target.num_vertices(), target.mesh().num_faces()};
  Measured result;
  const MatchContent map =
      read_matches(arguments.map, checks, told_numbering(arguments.one_based), &result.map);
  result.evaluation = results::evaluate(source, target, results::measured_map(target, map),
                                        arguments.truth, arguments.options, context);
  if (!arguments.registered.empty())
    result.evaluation.registered = measure_registered(
        source.mesh(), registered_vertices(arguments.registered, source), target.mesh(), context);
  return result;
}

void print_errors(std::string_view name, const ErrorStatistics& error) {
  fmt::print("  {:<32}mean {:.4f}  median {:.4f}  p95 {:.4f}  max {:.4f}\n", name, error.mean,
             error.median, error.p95, error.maximum);
}

std::string figure(const std::optional<double>& value) {
  return value ? fmt::format("{:.4f}", *value) : "none";
}

void print(const OverlapQuality& overlap, std::string_view unit) {
  fmt::print("  matched                         {:.1f} % of {}, truly {:.1f} %: IoU {}\n",
             100 * overlap.matched(), unit, 100 * overlap.truly_matched(), figure(overlap.iou()));
  fmt::print("  unmatched                       precision {}  recall {}\n",
             figure(overlap.unmatched_precision()), figure(overlap.unmatched_recall()));
}

void print_d_grd(std::string_view name, const ErrorStatistics& errors) {
  fmt::print("  {:<32}mean {:.4f}  maximum (d_grd-dagger) {:.4f}\n", name, errors.mean,
             errors.maximum);
}

void print(const results::TrueMapEvaluation& truth) {
  const OverlapErrors& errors = truth.match_errors;
  fmt::print("against the map that is the truth, {} matches on the overlap\n",
             errors.over_sqrt_area.samples);
  print(truth.overlap, "the source's area");
  if (errors.over_sqrt_area.samples == 0) return;
  const auto& points = truth.point_errors;
  print_errors("error / sqrt(area of target)", errors.over_sqrt_area);
  if (points) print_errors("the same of points on triangles", points->over_sqrt_area);
  print_d_grd("D_grd / maximum geodesic", errors.over_max_geodesic);
  if (points) print_d_grd("the same of points on triangles", points->over_max_geodesic);
}

void print(std::string_view name, const results::TruthEvaluation& truth) {
  fmt::print("{}, {} of {} template points on both surfaces\n", name, truth.points,
             truth.points_in_files);
  if (truth.overlap.both < 1) print(truth.overlap, "template points");
  print_errors("error / sqrt(area of target)", truth.template_errors);
  if (truth.point_errors) print_errors("the same of points on triangles", *truth.point_errors);
  print_d_grd("D_grd / maximum geodesic", truth.match_errors);
}

void print(const RegisteredSurface& surface) {
  fmt::print("the registered source\n");
  fmt::print("  triangles                       {:.2f} % at folds, {:.2f} % squeezed\n",
             100 * surface.folded, 100 * surface.squeezed);
  fmt::print("  reach                           {:.1f} % of the target's area\n",
             100 * surface.reach);
}

void print(const results::Evaluation& evaluation) {
  const MapOrientation& orientation = evaluation.orientation;
  fmt::print("{} matches\n", evaluation.distortion.matches);
  fmt::print("  D_iso / maximum geodesic        mean {:.4f}  maximum (d_iso-dagger) {:.4f}\n",
             evaluation.distortion.mean, evaluation.distortion.maximum);
  fmt::print("  target hit                      {:.1f} % of vertices, {:.1f} % of area\n",
             100 * evaluation.coverage.vertices, 100 * evaluation.coverage.area);
  fmt::print("  orientation                     {}: preserved around {:.0f} % of {} landmarks\n",
             to_string(orientation.verdict), 100 * orientation.preserved_share, orientation.votes);
  if (evaluation.truth) print("against the ground truth", *evaluation.truth);
  if (evaluation.symmetric_truth) {
    print("against the symmetric ground truth", *evaluation.symmetric_truth);
    fmt::print("  symmetric flip                  {}\n", evaluation.flipped() ? "yes" : "no");
  }
  if (evaluation.true_map) print(*evaluation.true_map);
  if (evaluation.registered) print(*evaluation.registered);
}

void run_eval(const EvalArguments& arguments, const Context& context) {
  const Measured measured = measure(arguments, context);
  ProgressBar::make_room();
  if (arguments.json) {
    results::Json json{{"map_numbered_from", static_cast<int>(measured.map.numbering)}};
    json.update(results::to_json(measured.evaluation));
    fmt::print("{}\n", json.dump(2));
    return;
  }
  if (const auto note = numbering_note(arguments.map, measured.map, arguments.one_based))
    fmt::print("{}\n", *note);
  print(measured.evaluation);
}

void add_files(CLI::App& command, EvalArguments& arguments) {
  command.add_option("SOURCE", arguments.source, "Mesh that the map starts from")->required();
  command.add_option("TARGET", arguments.target, "Mesh that the map leads to")->required();
  command
      .add_option(
          "MAP", arguments.map,
          "Target vertex of each source vertex, one a line (.txt .map .vts); or source and "
          "target vertex a line (.txt .map); or target face and three weights of each source "
          "vertex (.bary.txt); or arrays of either (.npz)")
      ->required();
  auto* source_truth =
      command.add_option("--gt-source", arguments.truth.source, "Ground truth on the source")
          ->type_name("FILE");
  auto* target_truth =
      command.add_option("--gt-target", arguments.truth.target, "Ground truth on the target")
          ->type_name("FILE")
          ->needs(source_truth);
  source_truth->needs(target_truth);
  command
      .add_option("--gt-target-sym", arguments.truth.symmetric_target,
                  "Ground truth on the target under the left-right symmetry")
      ->type_name("FILE")
      ->needs(target_truth);
  command
      .add_option("--gt-map", arguments.truth.map,
                  "Ground truth as a map of every source vertex, in the formats of MAP but pairs, "
                  "numbered from zero, -1 where the target has no counterpart; tells also how well "
                  "MAP leaves those out")
      ->type_name("FILE");
  command
      .add_option("--registered", arguments.registered,
                  "The source bent onto the target, such as the registered.ply of a result: tells "
                  "what became of its surface, and how much of the target it reaches")
      ->type_name("FILE");
}

}  // namespace

void add_eval(CLI::App& app, Request& request) {
  const auto arguments = std::make_shared<EvalArguments>();
  CLI::App& command = *app.add_subcommand("eval", "Measure the quality of a map");
  add_files(command, *arguments);
  command.add_flag(
      "--one-based", arguments->one_based,
      "MAP numbers from one; without this from zero unless that cannot be; .vts always "
      "does, .npz never");
  command
      .add_option("--samples", arguments->options.truth.max_samples,
                  "Most ground-truth errors to compute, evenly spaced")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      .add_option("--list", arguments->options.distortion.list_size,
                  "Matches that distortion is measured against (E)")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_flag("--json", arguments->json, "Print JSON");
  add_run_options(command, request);
  set_example(command,
              "isomatch eval cat0.off cat1.off result/source_to_target.txt --gt-source cat0.vts "
              "--gt-target cat1.vts --gt-target-sym cat1.sym.vts",
              "metrics.md");
  command.callback([arguments, &request] {
    request.action = [arguments](const Context& context) { run_eval(*arguments, context); };
  });
}

}  // namespace isomatch::cli
