// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::tracked {

struct SimplifiedMesh {
  Mesh mesh;
  /// The vertices that were kept, ascending.
  std::vector<int> kept;
};

/// A mesh of about `count` of the vertices of `mesh` that departs from it as little as possible, by
/// quadric errors; itself if it has no more. Every vertex must have a face. O(N log N).
SimplifiedMesh simplify(const Mesh& mesh, int count);

}  // namespace isomatch::tracked
