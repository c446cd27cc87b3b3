// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <pybind11/pybind11.h>

#include "results/folder/paper_output.h"
#include "results/folder/tracked_output.h"
#include "shapes.h"

/// What makes a match anew: plain values and arrays for pickle, without the meshes.
namespace isomatch::python {

/// A match by the tracked method.
struct TrackedMatch : results::TrackedRun {
  /// Whether its maps have the inverse that the method made. Where a folder does not, the inverse
  /// says of the best map what its relation of vertices says, and nothing of the others.
  bool has_inverse = true;
};

pybind11::tuple to_state(const TrackedMatch& match);
pybind11::tuple to_state(const results::PaperRun& run);

/// The match between the same meshes of which `state` was made. Throws `InvalidInput` if it does
/// not fit them.
TrackedMatch to_tracked(const MatchInput& source, const MatchInput& target,
                        const pybind11::tuple& state);
results::PaperRun to_paper(const MatchInput& source, const MatchInput& target,
                           const pybind11::tuple& state);

}  // namespace isomatch::python
