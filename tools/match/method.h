// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "isomatch/context.h"
#include "results/evaluation.h"

namespace isomatch::cli {

/// What every method of `isomatch match` takes.
struct MatchArguments {
  std::string source, target, folder;
  /// The command line, for the report.
  std::vector<std::string> words;
  unsigned long seed = 0;
  /// Whether a page follows, report.html, and the truth that it shows.
  bool page = false;
  TruthFiles truth;
  bool quiet = false;
};

/// Loads both meshes, matches them, writes the results and prints a summary.
using Method = std::function<void(const MatchArguments&, const Context&)>;

/// Each adds one method's own options to `command`, in the option group `group`.
Method add_tracked_method(CLI::App& command, const std::string& group);
Method add_paper_method(CLI::App& command, const std::string& group);

}  // namespace isomatch::cli
