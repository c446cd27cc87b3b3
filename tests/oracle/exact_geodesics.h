// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::test {

/// Exact geodesic distances from `source` to all vertices (Xin and Wang's algorithm in CGAL),
/// infinite where not connected. `mesh` must be manifold and consistently oriented.
std::vector<double> exact_distances(const Mesh& mesh, int source);

}  // namespace isomatch::test
