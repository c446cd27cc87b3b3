// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/mesh/connectivity.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// What a mesh is made of, what is unusual about it, and what matching makes of it.
struct MeshDiagnosis {
  // The mesh as given.
  int vertices = 0;
  int faces = 0;
  /// Of all faces whose area is finite.
  double area = 0;
  /// Faces with a repeated vertex or an area that is zero up to the rounding of the coordinates.
  int degenerate_faces = 0;
  /// Faces with the same three vertices as a face of lower index that is not degenerate.
  int duplicate_faces = 0;
  /// Vertices that no face names.
  int unreferenced_vertices = 0;
  /// Vertices whose position equals that of a vertex with a lower index.
  int duplicate_vertices = 0;
  /// Vertices with a coordinate that is infinite or not a number, and vertices far outside of the
  /// shape at the end of long edges. They are no part of the surface, nor are their faces.
  int not_finite_vertices = 0, stray_vertices = 0;
  /// Vertices of open borders closer than a hundredth of the mean edge to another one, not equal.
  int near_seam_vertices = 0;
  /// Its connectivity without degenerate and duplicate faces, seams of split vertices left open.
  Connectivity given;

  // The surface that matching works on (see `Shape`); all zero if no face has an area.
  Connectivity surface;
  /// Components after joining seams; all but the largest stay unmatched.
  int components = 0;
  /// Pairs of boundary edges joined, over all components.
  int joined_edges = 0;
  /// Input vertices that are part of the surface, each copy at a seam counted.
  int matchable_vertices = 0;
  /// Area of the surface over that of all components together.
  double matchable_area_share = 0;
  /// Lengths of its edges, in units of the coordinates.
  double min_edge = 0, mean_edge = 0, max_edge = 0;
  /// Edges longer than 20 times the mean and than half of sqrt(area).
  int long_edges = 0;

  /// One plain sentence for each defect that matching has to work around; empty for a closed, sound
  /// mesh in one piece.
  std::vector<std::string> warnings() const;
  /// Those of the warnings for which a map is not to be trusted without a look, so that no fit is
  /// called good.
  std::vector<std::string> grave_warnings() const;
};

/// Throws `InvalidInput` if `mesh` fails `validate`. O(N log N).
MeshDiagnosis diagnose(const Mesh& mesh);

/// For each vertex itself or, where it is not finite or stray (see `MeshDiagnosis`), another one,
/// preferably of its faces, that can stand for it where a mesh is drawn or its extent is asked for.
/// O(N).
std::vector<int> stand_ins(const Mesh& mesh);

}  // namespace isomatch
