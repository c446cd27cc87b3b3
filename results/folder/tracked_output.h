// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>

#include "isomatch/methods/tracked.h"
#include "results/folder/inputs.h"
#include "results/folder/result.h"
#include "results/folder/result_folder.h"
#include "results/folder/verdict.h"
#include "results/json.h"

namespace isomatch::results {

/// Everything that a match by the tracked method leaves behind.
struct TrackedRun {
  MatchInputs inputs;
  Json options;
  TrackedResult result = {};
  /// Of each map.
  std::vector<Fit> fits = {};
  bool target_to_source = false;
  /// Of the best map, the mean relative to sqrt(area) of the target, where the truth is known.
  std::optional<double> point_error = {};
};

/// Of the source, those that the map leads to a point.
int matched_vertices(const TrackedMap& map);

/// Besides the fit and the defects of the meshes, why one should look at the map: a sentence each.
std::vector<std::string> doubts(const TrackedRun& run);

/// Writes into the folder of `plan` (see `ResultFolder`), in the numbers of the input files:
/// - source_to_target.txt: the nearest target vertex of every source vertex;
/// - source_to_target.bary.txt: the target face of every source vertex, and the weights;
/// - target_to_source.txt and .bary.txt: the same the other way round, if asked for;
/// - source_confidence.txt, and target_confidence.txt with the inverse: how sure each point is;
/// - registered.ply: the source in the target's pose;
/// - correspondence.txt: the many-to-many relation of the best map;
/// - alternatives/K/: the maps of the alternatives, from 1, under the same names;
/// - report.json, which is returned.
Json write_tracked(const ResultPlan& plan, const TrackedRun& run);

/// Map K of `run`, 0 the best, as it is written: in the numbers of the input files.
ResultMap result_map(const TrackedRun& run, std::size_t k);
/// The many-to-many relation of the best map.
Correspondence relation(const TrackedRun& run);

/// The names of what it may write, with this many alternatives at most; but for report.json.
std::vector<std::string> tracked_files(int alternatives, bool target_to_source);

}  // namespace isomatch::results
