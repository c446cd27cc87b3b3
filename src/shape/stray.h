// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// Of each vertex whether it can be part of a surface.
enum class VertexKind : char {
  kSound,
  /// A coordinate is not a number, or infinite.
  kNotFinite,
  /// The tip of a spike, as scanners leave them: at least four times as far from the middle as all
  /// but a hundredth of the vertices are, and joined to the others by long edges only.
  kStray
};

/// O(N).
std::vector<VertexKind> vertex_kinds(const Mesh& mesh);

/// Vertices on open borders that nearly coincide with another one, closer than a hundredth of the
/// mean edge but not equal: sides of a seam that exact comparison does not join. `mesh` is sound.
/// O(N log N).
int count_near_seam_vertices(const Mesh& mesh);

}  // namespace isomatch
