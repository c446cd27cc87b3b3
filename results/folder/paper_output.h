// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <string>
#include <vector>

#include "isomatch/methods/paper.h"
#include "results/folder/inputs.h"
#include "results/folder/levels.h"
#include "results/folder/result.h"
#include "results/folder/result_folder.h"
#include "results/folder/verdict.h"
#include "results/json.h"

namespace isomatch::results {

/// Everything that a match by the paper's method leaves behind.
struct PaperRun {
  MatchInputs inputs;
  Json options;
  PaperResult result;
  /// Of source and target, over which distortions are given.
  std::array<double, 2> max_geodesics;
  Fit fit;
};

/// Writes into the folder of `plan` (see `ResultFolder`), in the numbers of the input files:
/// - source_to_target.txt: the target vertex of every source vertex;
/// - correspondence.txt: the many-to-many result, with d_iso;
/// - levels/KK.correspondence.txt and levels/KK.many_to_one.txt: xi(k) and xi(k,1) of level k;
/// - levels.json and report.json, which is returned.
Json write_paper(const ResultPlan& plan, const PaperRun& run);

/// The map and the levels of `run` as they are written: in the numbers of the input files.
ResultMap result_map(const PaperRun& run);
std::vector<ResultLevel> result_levels(const PaperRun& run);

/// The names of what it may write, with this last level at most; but for report.json.
std::vector<std::string> paper_files(int max_levels);

}  // namespace isomatch::results
