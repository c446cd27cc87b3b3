// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// Vertices of edges that have one face, ascending. O(N log N).
std::vector<int> boundary_vertices(const Mesh& mesh);

/// Sum of the lengths of such edges. O(N log N).
double boundary_length(const Mesh& mesh);

}  // namespace isomatch
