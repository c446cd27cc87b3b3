// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// How the open seams of a mesh close.
struct Seams {
  /// For each vertex the lowest vertex it becomes one with, itself where nothing is joined.
  std::vector<int> joined_vertex;
  /// Pairs of boundary edges that became one.
  int joined_edges = 0;
};

/// Joins boundary edges pairwise where the positions of their ends are equal. `mesh` has neither
/// degenerate nor duplicate faces, and its coinciding vertices are adjacent (see `SoundMesh`).
///
/// Two edges do not join if their faces coincide, as those of a sheet and its copy do. Where more
/// than two boundary edges coincide, they stay open, except that coinciding faces count once and
/// the one of the component with the lowest vertex joins. Joins that would make an edge of more
/// than two faces, or two equal faces, are left open at the vertices concerned. O(N log N).
Seams join_seams(const Mesh& mesh);

}  // namespace isomatch
