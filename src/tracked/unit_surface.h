// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/surface.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::tracked {

/// A surface scaled to unit area and centred, with normals. Faces are turned outwards if
/// `oriented`.
struct UnitSurface {
  Mesh mesh;
  /// Coordinates of the surface are `scale` times those of `mesh` plus `centre`.
  double scale = 1;
  Point centre{0, 0, 0};
  IndexLists faces;
  /// Whether it is known which side is outside.
  bool oriented = false;
  /// For each face whether its corners 1 and 2 were exchanged to turn it outwards.
  std::vector<bool> turned;
  /// Area-weighted unit normals of the vertices.
  std::vector<Point> normals;
};

/// `mirrored` reflects the coordinates first. O(N log N).
UnitSurface unit_surface(const Surface& surface, bool mirrored = false);

std::vector<Point> unit_normals(const Mesh& mesh);

}  // namespace isomatch::tracked
