// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/methods/paper.h"
#include "results/folder/inputs.h"
#include "results/folder/measured_matches.h"

namespace isomatch::results {

/// Matches between the bases of a result of the paper's method, and the distortion of each, as
/// matches between vertices with all their copies at seams.
MeasuredMatches between_vertices(const MatchInputs& inputs, const PaperResult& result,
                                 const Correspondence& matches,
                                 const std::vector<double>& distortion);

}  // namespace isomatch::results
