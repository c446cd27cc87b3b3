// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/context.h"
#include "method.h"
#include "results/evaluation.h"
#include "results/json.h"

namespace isomatch::baselines {

/// What every method is measured on.
struct Pair {
  std::string source, target;
  results::TruthFiles truth;
};

struct MeasureOptions {
  /// Names of the maps to evaluate, of those that a method makes.
  std::vector<std::string> maps{kFinalMap};
  results::EvaluationOptions evaluation;
  /// Folder for the final maps, METHOD.txt and METHOD.bary.txt; empty to write none.
  std::string map_folder;
};

/// Runs `method` on a pair and measures time, memory and maps; see the program's documentation for
/// the fields. A method that throws anything but `BadFile` and `Cancelled` leaves a field "failure"
/// with the reason instead of figures.
results::Json measure(const Method& method, const Pair& pair, const MeasureOptions& options,
                      const Context& context);

}  // namespace isomatch::baselines
