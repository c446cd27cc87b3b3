// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/tracked.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "isomatch/error.h"
#include "isomatch/map_io.h"
#include "isomatch/metrics.h"
#include "match/method.h"
#include "match/report.h"
#include "match/tracked_output.h"

namespace isomatch::cli {
namespace {

struct TrackedArguments {
  TrackedOptions options;
  std::string landmarks;
  bool target_to_source = false;
};

void check_on_surface(const std::string& file, const char* side, const Surface& surface,
                      int vertex) {
  if (surface.surface_vertex[vertex] == kNoVertex)
    throw BadFile(file,
                  fmt::format("{} vertex {} is not on the surface that is matched", side, vertex));
}

/// The landmarks in `file` as pairs of surface vertices.
Correspondence load_landmarks(const std::string& file, const MatchInputs& inputs) {
  const Surface& source = inputs.source.surface;
  const Surface& target = inputs.target.surface;
  const std::vector<Match> pairs =
      read_landmarks(file, {inputs.source.mesh.num_vertices(), inputs.target.mesh.num_vertices()});
  for (const Match& pair : pairs) {
    check_on_surface(file, "source", source, pair.source);
    check_on_surface(file, "target", target, pair.target);
  }
  Correspondence landmarks = surface_matches(source, target, pairs);
  const auto twice = std::ranges::adjacent_find(landmarks, {}, &Match::source);
  if (twice != landmarks.end())
    throw BadFile(file, fmt::format("copies of source vertex {} on a seam have different landmarks",
                                    source.input_vertex[twice->source]));
  return landmarks;
}

Json tracked_options_json(const MatchArguments& arguments, const TrackedArguments& tracked) {
  Json json = options_json(arguments, "tracked");
  json["allow-reflection"] = tracked.options.allow_reflection;
  json["alternatives"] = tracked.options.alternatives;
  json["orientation"] = tracked.options.orientation;
  json["elastic-judging"] = tracked.options.elastic_judging;
  json["refinement"] = tracked.options.refinement;
  json["landmarks"] = tracked.landmarks.empty() ? Json() : Json(tracked.landmarks);
  json["target-to-source"] = tracked.target_to_source;
  return json;
}

std::string describe_confidence(const TrackedRun& run) {
  const TrackedResult& result = run.result;
  if (result.confidence >= 1) return "clear: there was no other";
  if (result.confidence >= kClearConfidence) return fmt::format("clear, {:.2f}", result.confidence);
  return fmt::format("ambiguous, {:.2f}: the second best map differs and is nearly as good",
                     result.confidence);
}

void print_summary(const TrackedRun& run, const std::string& folder) {
  const TrackedResult& result = run.result;
  const TrackedMap& best = result.maps.front();
  fmt::print("{} of {} source vertices matched, energy {:.3g}, distance {:.3g} (at unit area)\n",
             matched_vertices(run, best), run.inputs.source.mesh.num_vertices(), best.energy,
             best.distance);
  fmt::print("choice among maps: {}\n", describe_confidence(run));
  const std::size_t wanted = run.options["alternatives"];
  if (wanted > 0) fmt::print("{} of {} alternatives found\n", result.maps.size() - 1, wanted);
  if (!result.oriented && !run.options["allow-reflection"])
    fmt::print("! a surface does not tell outside from inside: the map may be mirrored\n");
  print_closing(run.inputs, folder);
}

void run_tracked(const MatchArguments& arguments, TrackedArguments tracked,
                 const Context& context) {
  tracked.options.validate();
  MatchInputs inputs = load_inputs(arguments, context);
  if (!tracked.landmarks.empty())
    tracked.options.landmarks = load_landmarks(tracked.landmarks, inputs);
  TrackedResult result = match_tracked(inputs.source.surface, inputs.target.surface,
                                       tracked.options, matching_part(context));
  const TrackedRun run{std::move(inputs), tracked_options_json(arguments, tracked),
                       std::move(result), tracked.target_to_source};
  context.report(kMatched, "writing");
  write_tracked(arguments.folder, run);
  if (!arguments.quiet) print_summary(run, arguments.folder);
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
      ->type_name("K")
      ->check(CLI::NonNegativeNumber)
      ->group(group)
      ->capture_default_str();
  command
      .add_option("--landmarks", tracked->landmarks,
                  "Vertices that must match: source and target vertex a line, from 0")
      ->type_name("FILE")
      ->group(group);
  command
      .add_flag("--target-to-source", tracked->target_to_source, "Write the inverse map as well")
      ->group(group);
  return [tracked](const MatchArguments& arguments, const Context& context) {
    run_tracked(arguments, *tracked, context);
  };
}

}  // namespace isomatch::cli
