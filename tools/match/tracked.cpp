// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/tracked.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "match/method.h"
#include "match/outcome.h"
#include "match/tracked_options.h"
#include "results/folder/report.h"
#include "results/folder/tracked_output.h"
#include "results/option_names.h"

namespace isomatch::cli {
namespace {

struct TrackedArguments {
  TrackedOptions options;
  std::string landmarks;
  bool one_based = false;
  bool target_to_source = false;
};

void load_landmarks(const results::MatchInputs& inputs, TrackedArguments& tracked) {
  tracked.options.landmarks = read_landmarks(
      tracked.landmarks, {inputs.source.mesh().num_vertices(), inputs.target.mesh().num_vertices()},
      tracked.one_based ? Numbering::kFromOne : Numbering::kFromZero);
  try {
    check_landmarks(inputs.source.shape, inputs.target.shape, tracked.options.landmarks);
  } catch (const InvalidInput& error) {
    throw BadFile(tracked.landmarks, error.what());
  }
}

results::Json tracked_options_json(const TrackedArguments& tracked) {
  results::Json json = results::options_json("tracked");
  results::add_options(json, tracked.options);
  json["landmarks"] = results::Json();
  if (!tracked.landmarks.empty()) results::set_path(json, "landmarks", tracked.landmarks);
  if (tracked.one_based) json["one-based"] = true;
  json["target-to-source"] = tracked.target_to_source;
  return json;
}

Summary summary_of(const results::TrackedRun& run) {
  const TrackedResult& result = run.result;
  Summary summary;
  summary.lines.push_back(fmt::format("{} of {} source vertices matched",
                                      results::matched_vertices(result.maps.front()),
                                      run.inputs.source.mesh().num_vertices()));
  const std::size_t wanted = run.options["alternatives"];
  if (wanted > 0)
    summary.lines.push_back(
        fmt::format("{} of {} alternatives found", result.maps.size() - 1, wanted));
  summary.remarks = results::doubts(run);
  return summary;
}

std::optional<results::ShownMatch> run_tracked(const MatchArguments& arguments,
                                               TrackedArguments tracked, const Context& context) {
  tracked.options.validate();
  const results::ResultPlan plan = make_plan(
      arguments, results::tracked_files(tracked.options.alternatives, tracked.target_to_source),
      tracked.landmarks);
  results::check_plan(plan);
  results::MatchInputs inputs = load_inputs(arguments, {}, context);
  if (!tracked.landmarks.empty()) load_landmarks(inputs, tracked);
  TrackedResult result = match_tracked(inputs.source.shape, inputs.target.shape, tracked.options,
                                       results::matching_part(context));
  std::vector<Fit> fits = results::fits_of(inputs, result, context);
  const results::TrackedRun run{std::move(inputs), tracked_options_json(tracked), std::move(result),
                                std::move(fits), tracked.target_to_source};
  context.report(results::kJudged, "writing");
  results::Json report = results::write_tracked(plan, run);
  print_outcome(run.inputs, summary_of(run), run.fits.front(), arguments.folder, arguments.quiet);
  return shown_if_asked(arguments, run, std::move(report));
}

}  // namespace

Method add_tracked_method(CLI::App& command, const std::string& group) {
  const auto tracked = std::make_shared<TrackedArguments>();
  add_tracked_options(command, group, tracked->options);
  add_map_options(command, group, tracked->options, tracked->target_to_source);
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
  return [tracked](const MatchArguments& arguments, const Context& context) {
    return run_tracked(arguments, *tracked, context);
  };
}

}  // namespace isomatch::cli
