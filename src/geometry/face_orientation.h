// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// For each face 1 if its corners run counter-clockwise seen from outside, -1 if clockwise. Faces
/// that meet at an edge of two are oriented alike, each such patch as most of its area is in the
/// file; if the mesh is closed or nearly so, outside is where it encloses a positive volume.
/// Nothing if the mesh is not orientable, or if the file's faces are turned at random, so that they
/// do not tell which side is which. O(N log N).
std::optional<std::vector<signed char>> face_orientation(const Mesh& mesh);

}  // namespace isomatch
