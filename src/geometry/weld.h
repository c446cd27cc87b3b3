// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// A mesh whose vertices at equal positions have become one, so that the seams of split vertices
/// that texture coordinates leave close. Faces keep their numbers and the order of their corners.
struct WeldedMesh {
  Mesh mesh;
  /// Welded vertex of each vertex.
  std::vector<int> vertex;
};

/// Welded vertices are numbered in order of first appearance. O(N).
WeldedMesh weld(const Mesh& mesh);

}  // namespace isomatch
