// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh.h"

namespace isomatch {

/// The faces of a mesh that carry its surface.
struct SoundFaces {
  /// `mesh` with only the sound faces, all vertices kept.
  Mesh mesh;
  /// For each face of `mesh` its index in the input, ascending.
  std::vector<int> input_face;
  /// Left out because a vertex repeats or the area is zero (up to the rounding of the coordinates).
  int degenerate_faces = 0;
  /// Left out because a face of lower index has the same three vertices.
  int duplicate_faces = 0;
};

/// Sorts out the faces of a valid mesh. O(N log N) at worst, O(N) as a rule.
SoundFaces sound_faces(const Mesh& input);

}  // namespace isomatch
