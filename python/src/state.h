// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "results/folder/paper_output.h"
#include "results/folder/tracked_output.h"
#include "results/group/group_run.h"
#include "shapes.h"

/// What makes a match anew: plain values and arrays for pickle, without the meshes.
namespace isomatch::python {

/// A match by the tracked method.
struct TrackedMatch : results::TrackedRun {
  /// Whether its maps have the inverse that the method made. Where a folder does not, the inverse
  /// says of the best map what its relation of vertices says, and nothing of the others.
  bool has_inverse = true;
};

/// A collection that was matched, and which vertices of its template are the points that are
/// wanted. `run.words` and paths stay empty until it is saved.
struct GroupMatch {
  results::GroupRun run;
  std::vector<int> vertices;
};

using GroupShapes = std::vector<std::shared_ptr<MatchInput>>;

/// One that is not matched yet.
GroupMatch to_group(const GroupShapes& shapes, std::vector<std::string> names);

pybind11::tuple to_state(const TrackedMatch& match);
pybind11::tuple to_state(const results::PaperRun& run);
pybind11::tuple to_state(const GroupMatch& group);

/// The match between the same meshes of which `state` was made. Throws `InvalidInput` if it does
/// not fit them.
TrackedMatch to_tracked(const MatchInput& source, const MatchInput& target,
                        const pybind11::tuple& state);
results::PaperRun to_paper(const MatchInput& source, const MatchInput& target,
                           const pybind11::tuple& state);
GroupMatch to_group(const GroupShapes& shapes, std::vector<std::string> names,
                    const pybind11::tuple& state);

}  // namespace isomatch::python
