// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "results/folder/inputs.h"
#include "results/folder/verdict.h"

namespace isomatch::cli {

/// What a method tells of a match in its own words.
struct Summary {
  /// How it went.
  std::vector<std::string> lines;
  /// What else, besides a fit that is not good, should make one look at the map.
  std::vector<std::string> remarks;
};

/// Tells how a match went: `summary`, the fit, what is wrong with the map and the meshes, and where
/// the results are. With `quiet` only what is wrong, on standard error.
void print_outcome(const results::MatchInputs& inputs, const Summary& summary, const Fit& fit,
                   const std::string& folder, bool quiet);

}  // namespace isomatch::cli
