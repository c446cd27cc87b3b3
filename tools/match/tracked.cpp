// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/tracked.h"

#include <fmt/format.h>

#include <memory>

#include "isomatch/error.h"
#include "isomatch/map_io.h"
#include "load.h"
#include "match/input_numbers.h"
#include "match/method.h"
#include "match/option_names.h"
#include "match/report.h"
#include "match/tracked_output.h"
#include "progress_bar.h"

namespace isomatch::cli {
namespace {

struct TrackedArguments {
  TrackedOptions options;
  std::string landmarks;
  bool one_based = false;
  bool target_to_source = false;
};

/// The landmarks in the file as pairs of surface vertices.
Correspondence load_landmarks(const TrackedArguments& tracked, const MatchInputs& inputs) {
  const std::string& file = tracked.landmarks;
  const std::vector<Match> pairs =
      read_landmarks(file, {inputs.source.mesh.num_vertices(), inputs.target.mesh.num_vertices()},
                     tracked.one_based ? Numbering::kFromOne : Numbering::kFromZero);
  try {
    return surface_landmarks(inputs, pairs);
  } catch (const InvalidInput& error) {
    throw BadFile(file, error.what());
  }
}

Json tracked_options_json(const MatchArguments& arguments, const TrackedArguments& tracked) {
  Json json = options_json("tracked", arguments.seed);
  add_options(json, tracked.options);
  json["landmarks"] = Json();
  if (!tracked.landmarks.empty()) set_path(json, "landmarks", tracked.landmarks);
  if (tracked.one_based) json["one-based"] = true;
  json["target-to-source"] = tracked.target_to_source;
  return json;
}

std::string describe_confidence(const TrackedRun& run) {
  const TrackedResult& result = run.result;
  if (has_grave_defects(run.inputs)) return "doubtful: see what is wrong with the shapes below";
  if (result.confidence >= 1) return "clear: there was no other";
  if (is_clear(run)) return fmt::format("clear, {:.2f}", result.confidence);
  return fmt::format("ambiguous, {:.2f}: the second best map differs and is nearly as good",
                     result.confidence);
}

bool may_be_mirrored(const TrackedRun& run) {
  return !run.result.oriented && !run.options["allow-reflection"];
}

constexpr std::string_view kMayBeMirrored =
    "a surface does not tell outside from inside: the map may be mirrored";

/// Of the summary what a user has to know.
void print_warnings(const TrackedRun& run) {
  if (!is_clear(run)) warn("choice among maps: " + describe_confidence(run));
  if (may_be_mirrored(run)) warn(kMayBeMirrored);
  warn_of_defects(run.inputs);
}

void print_summary(const TrackedRun& run, const std::string& folder) {
  ProgressBar::make_room();
  const TrackedResult& result = run.result;
  const TrackedMap& best = result.maps.front();
  fmt::print("{} of {} source vertices matched, energy {:.3g}, distance {:.3g} (at unit area)\n",
             matched_vertices(run, best), run.inputs.source.mesh.num_vertices(), best.energy,
             best.distance);
  fmt::print("choice among maps: {}\n", describe_confidence(run));
  const std::size_t wanted = run.options["alternatives"];
  if (wanted > 0) fmt::print("{} of {} alternatives found\n", result.maps.size() - 1, wanted);
  if (may_be_mirrored(run)) fmt::print("! {}\n", kMayBeMirrored);
  print_closing(run.inputs, folder);
}

void run_tracked(const MatchArguments& arguments, TrackedArguments tracked,
                 const Context& context) {
  tracked.options.validate();
  const ResultPlan plan =
      make_plan(arguments, tracked_files(tracked.options.alternatives, tracked.target_to_source),
                tracked.landmarks);
  check_plan(plan);
  MatchInputs inputs = load_inputs(arguments, context);
  if (!tracked.landmarks.empty()) tracked.options.landmarks = load_landmarks(tracked, inputs);
  TrackedResult result = match_tracked(inputs.source.surface, inputs.target.surface,
                                       tracked.options, matching_part(context));
  const TrackedRun run{std::move(inputs), tracked_options_json(arguments, tracked),
                       std::move(result), tracked.target_to_source};
  context.report(kMatched, "writing");
  write_tracked(plan, run);
  arguments.quiet ? print_warnings(run) : print_summary(run, arguments.folder);
}

}  // namespace

Method add_tracked_method(CLI::App& command, const std::string& group) {
  const auto tracked = std::make_shared<TrackedArguments>();
  TrackedOptions& options = tracked->options;
  command
      .add_flag("--allow-reflection", options.allow_reflection,
                "Try to match the mirror image of the source as well")
      ->group(group);
  command
      .add_flag("!--no-orientation", options.orientation,
                "Grow hypotheses by distances along the surface alone")
      ->group(group);
  command
      .add_flag("!--no-elastic-judging", options.elastic_judging,
                "Choose by distortion and orientation instead of elastic energy")
      ->group(group);
  command
      .add_flag("!--no-refinement", options.refinement, "Stop after a first, coarse registration")
      ->group(group);
  command.add_option("--alternatives", options.alternatives, "Maps to write besides the best one")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber)
      ->group(group)
      ->capture_default_str();
  command
      .add_option(
          "--landmarks", tracked->landmarks,
          "Vertices that must match, a text or CSV file: a line each, source vertex and target "
          "vertex from 0, between them a blank, tab, comma or semicolon; column names in the "
          "first line, blank lines and comments behind # are passed over")
      ->type_name("FILE")
      ->group(group);
  command
      .add_flag("--one-based", tracked->one_based, "The landmarks' vertices are numbered from 1")
      ->needs("--landmarks")
      ->group(group);
  command
      .add_flag("--target-to-source", tracked->target_to_source, "Write the inverse map as well")
      ->group(group);
  return [tracked](const MatchArguments& arguments, const Context& context) {
    run_tracked(arguments, *tracked, context);
  };
}

}  // namespace isomatch::cli
