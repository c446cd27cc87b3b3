// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <memory>

#include "match/method.h"
#include "match/paper_options.h"
#include "match/paper_output.h"
#include "match/report.h"

namespace isomatch::cli {
namespace {

Json paper_options_json(const MatchArguments& arguments, const PaperOptions& options) {
  Json json = options_json(arguments, "paper");
  for_each_paper_option(
      options, [&](const char* name, const auto& value, const char*) { json[name] = value; });
  return json;
}

void print_summary(const PaperRun& run, const std::string& folder) {
  const PaperLevel& last = run.result.levels.back();
  const DistortionSummary distortion = summarize(last.distortion);
  fmt::print("{} matches at level {}, D_iso {:.4f}, maximum {:.4f} (over the largest geodesic)\n",
             last.matches.size(), run.result.levels.size() - 1, distortion.mean, distortion.max);
  print_closing(run.inputs, folder);
}

void run_paper(const MatchArguments& arguments, const PaperOptions& options,
               const Context& context) {
  options.validate();
  MatchInputs inputs = load_inputs(arguments, context);
  PaperResult result =
      match_paper(inputs.source.shape, inputs.target.shape, options, matching_part(context));
  const PaperRun run{std::move(inputs), paper_options_json(arguments, options), std::move(result)};
  context.report(kMatched, "writing");
  write_paper(arguments.folder, run);
  if (!arguments.quiet) print_summary(run, arguments.folder);
}

}  // namespace

Method add_paper_method(CLI::App& command, const std::string& group) {
  const auto options = std::make_shared<PaperOptions>();
  for_each_paper_option(*options, [&](const char* name, auto& value, const char* help) {
    command.add_option(fmt::format("--{}", name), value, help)->group(group)->capture_default_str();
  });
  return [options](const MatchArguments& arguments, const Context& context) {
    run_paper(arguments, *options, context);
  };
}

}  // namespace isomatch::cli
