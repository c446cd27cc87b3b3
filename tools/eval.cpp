// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "evaluation.h"
#include "isomatch/map_io.h"
#include "isomatch/mesh_io.h"
#include "load.h"

namespace isomatch::cli {
namespace {

struct EvalArguments {
  std::string source, target, map;
  TruthFiles truth;
  bool one_based = false;
  bool json = false;
  EvaluationOptions options;
};

MeasuredMap read_map(const EvalArguments& arguments, const Shape& source, const Shape& target,
                     int target_faces) {
  const VertexCounts counts{input_vertex_count(source), input_vertex_count(target)};
  const Numbering numbering = arguments.one_based ? Numbering::kFromOne : Numbering::kFromZero;
  if (!arguments.map.ends_with(".bary.txt")) {
    const Correspondence matches = read_correspondence(arguments.map, counts, numbering);
    return {surface_matches(source.surface, target.surface, matches), {}};
  }
  const SurfaceMap points =
      surface_map(source.surface, target.surface,
                  read_surface_map(arguments.map, {counts.source, target_faces}, numbering));
  return {to_correspondence(nearest_vertices(target.surface.mesh, points)), points};
}

Evaluation evaluate(const EvalArguments& arguments, const Context& context) {
  const Shape source = load_shape(arguments.source, context);
  const Mesh target_mesh = load_mesh(arguments.target);
  const Shape target = prepare_loaded(arguments.target, target_mesh, context);
  const MeasuredMap map = read_map(arguments, source, target, target_mesh.num_faces());
  return evaluate(source, target, map, arguments.truth, arguments.options, context);
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
      command.add_option("--gt-source", arguments.truth.source, "Ground truth on the source")
          ->type_name("VTS");
  auto* target_truth =
      command.add_option("--gt-target", arguments.truth.target, "Ground truth on the target")
          ->type_name("VTS")
          ->needs(source_truth);
  source_truth->needs(target_truth);
  command
      .add_option("--gt-target-sym", arguments.truth.symmetric_target,
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
              "--gt-target cat1.vts --gt-target-sym cat1.sym.vts");
  command.callback([arguments, &request] {
    request.action = [arguments](const Context& context) { run_eval(*arguments, context); };
  });
}

}  // namespace isomatch::cli
