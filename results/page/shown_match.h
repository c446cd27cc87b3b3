// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/folder/levels.h"
#include "results/folder/paper_output.h"
#include "results/folder/result.h"
#include "results/folder/tracked_output.h"

namespace isomatch::results {

struct Shapes {
  Shape source, target;
};

/// All that a page shows of a match, in the numbers of the input files.
struct ShownMatch {
  MatchResult result;
  /// The many-to-many relation of the best map.
  Correspondence relation;
  /// Of the paper's method.
  std::vector<ResultLevel> levels;
  /// Those that were matched, if they are at hand.
  std::optional<Shapes> shapes;
};

/// A match whose results were written into `folder`, with `report` as its report.json. It is what
/// `load_shown` would read there.
ShownMatch shown_match(const TrackedRun& run, const std::string& folder, Json report);
ShownMatch shown_match(const PaperRun& run, const std::string& folder, Json report);

/// The match that left a folder behind. Throws `BadFile` as `load_result`.
ShownMatch load_shown(const std::string& folder, const MeshPlaces& places = {});

}  // namespace isomatch::results
