// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// What the faces of a mesh amount to as a surface. Positions play no part; neither do vertices
/// without a face and faces with a repeated vertex.
struct Connectivity {
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  /// Parts that share no vertex.
  int components = 0;
  /// Edges of one face.
  int boundary_edges = 0;
  /// Borders: each follows boundary edges and the surface between them around their ends, so that
  /// holes that meet in a vertex have one border. Edges of more than two faces may break a border
  /// into several.
  int boundary_loops = 0;
  /// Edges of more than two faces.
  int nonmanifold_edges = 0;
  /// Vertices in which parts of the surface touch that share no edge there.
  int nonmanifold_vertices = 0;
  /// Edges whose two faces traverse it in the same direction, so that they face opposite ways.
  int inconsistent_edges = 0;
  /// True if the faces can be turned so that no edge of two faces is inconsistent.
  bool orientable = true;

  bool operator==(const Connectivity&) const = default;
  int euler_characteristic() const { return vertices - edges + faces; }
  /// Number of handles, if the surface is connected, orientable, and free of non-manifold edges and
  /// vertices. Holes do not change it.
  std::optional<int> genus() const;
};

/// Throws nothing on a mesh that passes `validate`. O(N log N).
Connectivity connectivity(const Mesh& mesh);

}  // namespace isomatch
