// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "tracked/options.h"
#include "tracked/shape/detail.h"

namespace isomatch::tracked {

/// Vertices of a surface, ascending, without which parts that touch come apart.
using Cut = std::vector<int>;

Cut united(const Cut& a, const Cut& b);

/// Where parts may have been fused, such as a hand to a hip: along loops in valleys that open a
/// handle. The first cut takes always the loop in the deepest valley; each of the others avoids one
/// of its loops, since there are valleys where nothing is fused, such as necks. None if the detail
/// has no handles, or too many to be fused parts. O(N log N) for each handle and cut.
std::vector<Cut> possible_cuts(const Detail& detail, const ContactOptions& options,
                               const Context& context);

/// The detail without the vertices of a cut.
Detail without(const Detail& detail, const Cut& cut, const Context& context);

}  // namespace isomatch::tracked
