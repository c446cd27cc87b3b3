// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh.h"

namespace isomatch {

inline constexpr int kNoVertex = -1;

/// The part of a mesh that matching works on, renumbered for locality, and the way back.
///
/// `mesh` is the connected component of largest area, without degenerate (zero area or repeated
/// vertex) and duplicate faces and without unreferenced vertices. It may have boundaries,
/// non-manifold edges and vertices, and inconsistently oriented faces. Every vertex has a face.
/// Boundary edges whose ends coincide exactly (a seam of split vertices, as in files with texture
/// coordinates) are joined, so that several input vertices may share one surface vertex.
struct Surface {
  Mesh mesh;
  /// Surface vertex to input vertex (the lowest where a seam was joined).
  std::vector<int> input_vertex;
  /// Input vertex to surface vertex, `kNoVertex` where it is not part of the surface.
  std::vector<int> surface_vertex;
  /// Surface area of `mesh`.
  double area = 0;

  int num_vertices() const { return mesh.num_vertices(); }
};

/// Extracts the matchable surface of `input`, its vertices numbered along a Hilbert curve; ties go
/// to the lower input index. Throws `InvalidInput` if `input` fails `validate` or has no face of
/// positive area. O(N log N).
Surface extract_surface(const Mesh& input);

}  // namespace isomatch
