// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::results {

/// A mesh as a page shows it: its vertices renumbered so that neighbours lie together, simplified
/// if there are too many.
struct DisplayMesh {
  Mesh mesh;
  /// For each shown vertex its number in the file.
  std::vector<int> input_vertex;
  /// For each vertex of the file the shown vertex that stands for it: itself or the nearest.
  std::vector<int> shown_vertex;
  bool simplified = false;
};

/// Vertices that a page shows at most, about.
inline constexpr int kMaxShownVertices = 200000;

/// Faces begin with their lowest vertex and ascend by their vertices. O(N log N).
DisplayMesh display_mesh(const Mesh& mesh, int max_vertices = kMaxShownVertices);

}  // namespace isomatch::results
