// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "isomatch/context.h"
#include "results/evaluation.h"
#include "results/folder/inputs.h"
#include "results/folder/result_folder.h"
#include "results/page/shown_match.h"

namespace isomatch::cli {

/// What every method of `isomatch match` takes.
struct MatchArguments {
  std::string source, target, folder;
  /// The command line, for the report.
  std::vector<std::string> words;
  /// Whether a page follows, report.html, and the truth that it shows.
  bool page = false;
  results::TruthFiles truth;
  bool quiet = false;
};

/// Loads both meshes, matches them, writes the results and prints a summary. Returns what a page
/// shows of the match, if one follows.
using Method =
    std::function<std::optional<results::ShownMatch>(const MatchArguments&, const Context&)>;

/// Each adds one method's own options to `command`, in the option group `group`.
Method add_tracked_method(CLI::App& command, const std::string& group);
Method add_paper_method(CLI::App& command, const std::string& group);

/// What is going to be written: `files` of the method, and the page, if one follows. Of what is
/// read nothing may be touched, nor `more`, which may be empty.
results::ResultPlan make_plan(const MatchArguments& arguments, std::vector<std::string> files,
                              const std::string& more = "");

/// `results::load_inputs`, which tells of warnings.
results::MatchInputs load_inputs(const MatchArguments& arguments, const GeodesicOptions& geodesics,
                                 const Context& context);

/// What a page shows of `run`, whose results were written with `report`, if one follows.
template <class Run>
std::optional<results::ShownMatch> shown_if_asked(const MatchArguments& arguments, const Run& run,
                                                  results::Json report) {
  if (!arguments.page) return std::nullopt;
  return results::shown_match(run, arguments.folder, std::move(report));
}

}  // namespace isomatch::cli
