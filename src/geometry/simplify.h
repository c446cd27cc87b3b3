// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// The faces of a mesh of about `count` of the vertices of `mesh`, with their numbers, that departs
/// from it as little as possible, by quadric errors (Garland and Heckbert 1997); those of `mesh` if
/// it has no more. O(N log N).
std::vector<Face> simplified_faces(const Mesh& mesh, int count);

struct SimplifiedMesh {
  Mesh mesh;
  /// The vertices that were kept, ascending.
  std::vector<int> kept;
};

/// The mesh without the vertices that have no face, in the same order. O(N).
SimplifiedMesh without_unused_vertices(const Mesh& mesh);

/// The mesh of `simplified_faces`; `mesh` itself if it has no more vertices, all of which must have
/// a face.
SimplifiedMesh simplify(const Mesh& mesh, int count);

}  // namespace isomatch
