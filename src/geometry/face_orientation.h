// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {

/// Whether the face of `side` goes from the lower end of the edge to the higher.
bool is_ascending(const Mesh& mesh, const EdgeSide& side);

/// Whether `edge` has two faces and they go along it in the same way, so that they face opposite
/// ways.
bool is_inconsistent(const Mesh& mesh, std::span<const EdgeSide> edge);

/// Two faces across an edge of two; the sign is -1 if they face opposite ways.
struct Hinge {
  int f, g;
  double sign;
};

/// Those of a mesh whose faces, turned the same way, are less than a right angle apart. O(N log N).
std::vector<Hinge> hinges(const Mesh& mesh);

/// The orientation double cover: each face stands twice, as it is (2 f) and turned over (2 f + 1),
/// united across edges of two faces with the neighbours that face the same way. A patch is
/// one-sided if both are in one set. `sides` are the `sorted_edge_sides`.
DisjointSets orientation_cover(const Mesh& mesh, std::span<const EdgeSide> sides);

/// For each face 1 if its corners run counter-clockwise seen from outside, -1 if clockwise. Faces
/// that meet at an edge of two are oriented alike, each such patch as most of its area is in the
/// file; if the mesh is closed or nearly so, outside is where it encloses a positive volume.
/// Nothing if the mesh is not orientable, or if the file's faces are turned at random, so that they
/// do not tell which side is which. O(N log N).
std::optional<std::vector<signed char>> face_orientation(const Mesh& mesh);

}  // namespace isomatch
