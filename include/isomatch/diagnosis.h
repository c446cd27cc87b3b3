// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/mesh.h"

namespace isomatch {

/// What a mesh is made of and what is unusual about it. Counts refer to the mesh as given, except
/// where noted.
struct MeshDiagnosis {
  int vertices = 0;
  int faces = 0;
  double area = 0;
  /// Connected components that have a face, seams of coinciding vertices left open.
  int components = 0;
  int degenerate_faces = 0;
  int duplicate_faces = 0;
  int unreferenced_vertices = 0;
  /// Vertices whose position equals that of a vertex with a lower index.
  int duplicate_vertices = 0;
  int boundary_edges = 0;
  int boundary_loops = 0;
  /// Edges of more than two faces.
  int nonmanifold_edges = 0;
  /// Vertices whose faces form more than one fan.
  int nonmanifold_vertices = 0;
  /// Edges whose two faces traverse it in the same direction.
  int inconsistent_edges = 0;
  /// True if the faces of the largest component can be oriented consistently.
  bool orientable = true;
  /// V - E + F of the largest component's surface (see `Surface`).
  int euler_characteristic = 0;
  /// Genus of the largest component if it is orientable and manifold, otherwise -1.
  int genus = -1;
  /// Of the surface that matching uses (see `Surface`): vertices, share of the area.
  int matchable_vertices = 0;
  double matchable_area_share = 0;
  double min_edge = 0, mean_edge = 0, max_edge = 0;

  /// One plain sentence for each defect that matching has to work around; empty for a clean mesh.
  std::vector<std::string> warnings() const;
};

/// Inspects `mesh`. Throws `InvalidInput` if it fails `validate`. O(N log N).
MeshDiagnosis diagnose(const Mesh& mesh);

}  // namespace isomatch
