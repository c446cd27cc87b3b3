// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/correspondence.h"
#include "tracked/hypotheses/node_directions.h"
#include "tracked/options.h"

namespace isomatch::tracked {

/// Sets of matches between landmarks that look alike and whose distances agree, the largest first:
/// what of two shapes may overlap, however little it is. One grows from each match of alike
/// landmarks, always by the match that agrees best (spectral matching, Leordeanu and Hebert 2005,
/// finds only the largest). `shapes` have a row a landmark, see `local_shapes`.
/// O(matches^2 + matches * matches of a set).
std::vector<Correspondence> agreeing_clusters(
    const NodeDirections& source, const FloatMatrix& source_shapes, const NodeDirections& target,
    const FloatMatrix& target_shapes, const LocalShapeOptions& options, const Context& context);

}  // namespace isomatch::tracked
