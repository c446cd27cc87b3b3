// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/correspondence.h"
#include "tracked/options.h"
#include "tracked/shape/proxy.h"

namespace isomatch::tracked {

/// Nodes at the tips of a shape: local maxima of the integral geodesic distance. The first is the
/// greatest, each further one the farthest from those before, so that tips close together, such as
/// those of fingers, do not crowd out other limbs.
std::vector<int> extremities(const Proxy& proxy, const SeedOptions& options);

/// Partial injective matchings between two sets of nodes that roughly keep distances, best first.
/// Branch and bound. Matches are pairs of nodes. The first `fixed` nodes of both sets match.
std::vector<Correspondence> seed_matchings(const Proxy& source, const std::vector<int>& source_tips,
                                           const Proxy& target, const std::vector<int>& target_tips,
                                           int fixed, const SeedOptions& options);

}  // namespace isomatch::tracked
