// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "results/folder/inputs.h"
#include "results/folder/verdict.h"
#include "results/json.h"

namespace isomatch::cli {

/// The fields that every report begins and ends with.
Json report_head(const MatchInputs& inputs, const Json& options);
/// The stages of loading, then those of matching.
std::vector<StageTime> joined(std::vector<StageTime> loading,
                              const std::vector<StageTime>& matching);
Json report_tail(const std::vector<StageTime>& times);

/// Options of every method as they go into the report.
Json options_json(const std::string& method, unsigned long seed);

/// What a method tells of a match in its own words.
struct Summary {
  /// How it went.
  std::vector<std::string> lines;
  /// What else, besides a fit that is not good, should make one look at the map.
  std::vector<std::string> remarks;
};

/// Tells how a match went: `summary`, the fit, what is wrong with the map and the meshes, and where
/// the results are. With `quiet` only what is wrong, on standard error.
void print_outcome(const MatchInputs& inputs, const Summary& summary, const Fit& fit,
                   const std::string& folder, bool quiet);

}  // namespace isomatch::cli
