// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <array>
#include <concepts>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "match/method.h"
#include "match/outcome.h"
#include "results/folder/paper_output.h"
#include "results/folder/report.h"
#include "results/option_names.h"

namespace isomatch::cli {
namespace {

struct PaperArguments {
  PaperOptions options;
  std::string geodesics = "w20";
};

results::Json paper_options_json(const PaperArguments& paper) {
  results::Json json = results::options_json("paper");
  json["geodesics"] = paper.geodesics;
  results::add_options(json, paper.options);
  return json;
}

Summary summary_of(const PaperResult& result) {
  const PaperLevel& last = result.levels.back();
  const DistortionSummary distortion = summarize(last.distortion);
  return {
      {fmt::format("{} matches at level {}, D_iso {:.4f}, maximum {:.4f} (over the largest "
                   "geodesic distance)",
                   last.matches.size(), result.levels.size() - 1, distortion.mean, distortion.max)},
      {}};
}

std::optional<results::ShownMatch> run_paper(const MatchArguments& arguments,
                                             const PaperArguments& paper, const Context& context) {
  paper.options.validate();
  const results::ResultPlan plan =
      make_plan(arguments, results::paper_files(paper.options.max_levels));
  results::check_plan(plan);
  results::MatchInputs inputs =
      load_inputs(arguments, results::geodesic_options(paper.geodesics), context);
  const Shape &source = inputs.source.shape, &target = inputs.target.shape;
  PaperResult result = match_paper(source, target, paper.options, results::matching_part(context));
  Fit fit = results::fit_of(inputs, result, context);
  const std::array max_geodesics{source.max_geodesic(context), target.max_geodesic(context)};
  const results::PaperRun run{std::move(inputs), paper_options_json(paper), std::move(result),
                              max_geodesics, std::move(fit)};
  context.report(results::kJudged, "writing");
  results::Json report = results::write_paper(plan, run);
  print_outcome(run.inputs, summary_of(run.result), run.fit, arguments.folder, arguments.quiet);
  return shown_if_asked(arguments, run, std::move(report));
}

}  // namespace

Method add_paper_method(CLI::App& command, const std::string& group) {
  const auto paper = std::make_shared<PaperArguments>();
  command
      .add_option("--geodesics", paper->geodesics,
                  "w20 and w10: straight lines across triangles; edges: as in the paper")
      ->check(CLI::IsMember({"w20", "w10", "edges"}))
      ->group(group)
      ->capture_default_str();
  for_each_option(paper->options, [&](const char* field, auto& value, const char* help) {
    const std::string name = "--" + results::option_name(field);
    if constexpr (std::same_as<decltype(value), bool&>)  // The tracked method has --no-orientation.
      command.add_flag(name + ",--orientation", value, help)->group(group);
    else
      command.add_option(name, value, help)->group(group)->capture_default_str();
  });
  return [paper](const MatchArguments& arguments, const Context& context) {
    return run_paper(arguments, *paper, context);
  };
}

}  // namespace isomatch::cli
