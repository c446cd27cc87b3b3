// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/mesh.h"
#include "isomatch/mesh/topology.h"
#include "tracked/options.h"

namespace isomatch::tracked {

/// The places of a spectral step, but those of before where it tears a node away from the nodes
/// around it: on limbs thinner than the eigenfunctions oscillate it cannot tell places apart.
/// Places are indices of `positions`; `neighbours` are those of the nodes.
std::vector<int> untorn(const std::vector<int>& before, std::vector<int> after,
                        const IndexLists& neighbours, const std::vector<Point>& positions,
                        const Options& options);

}  // namespace isomatch::tracked
