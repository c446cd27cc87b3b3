// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "results/folder/result.h"
#include "state.h"

/// Matches from the folders that they were saved in.
namespace isomatch::python {

/// Reads the folder. Meshes that were given as arrays lie in it, wherever it is now; others are
/// looked for where they were, unless `places` tells. Throws `BadFile`.
results::MatchResult load_folder(const std::string& folder, results::MeshPlaces places);

/// The landmarks of the match, source and target vertices; none if their file is not there any
/// more. Throws `BadFile`.
std::vector<Match> landmarks_of(const results::MatchResult& folder);

/// The match that `folder` tells of, between the meshes that it was made of. Throws `BadFile`.
TrackedMatch tracked_of(const results::MatchResult& folder, const MatchInput& source,
                        const MatchInput& target);
/// The same by the paper's method. A folder does not have the order in which bases of one level
/// were selected: they are in that of their numbers.
results::PaperRun paper_of(const results::MatchResult& folder, const MatchInput& source,
                           const MatchInput& target);

}  // namespace isomatch::python
