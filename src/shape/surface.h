// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/topology.h"
#include "shape/extraction.h"

namespace isomatch {

/// The part of a mesh that is matched, scaled to unit area, or as `scaled` says, and centred. Its
/// vertices and faces have numbers of their own, which public functions never take or give: see
/// shape/numbers.h.
struct Surface {
  /// Faces are turned outwards if `oriented`.
  Mesh mesh;
  /// Coordinates of the caller's mesh are `scale` times those of `mesh` plus `centre`.
  double scale = 1;
  /// Of the surface in those coordinates.
  double area = 1;
  Point centre{0, 0, 0};
  IndexLists faces;
  /// Whether it is known which side is outside.
  bool oriented = false;
  /// For each face whether its corners 1 and 2 were exchanged to turn it outwards.
  std::vector<bool> turned;
  /// Area-weighted unit normals of the vertices.
  std::vector<Point> normals;
  /// A third of the area of the faces around each vertex.
  std::vector<double> vertex_areas;

  /// The lowest of the caller's vertices at each vertex, and all of them: several where a seam was
  /// joined.
  std::vector<int> input_vertex;
  IndexLists input_vertices;
  /// The vertex of each of the caller's vertices, `kNoVertex` where it is not part of the surface.
  std::vector<int> surface_vertex;
  /// The caller's face of each face, and how many the caller has.
  std::vector<int> input_face;
  int num_input_faces = 0;

  int num_vertices() const { return mesh.num_vertices(); }
};

/// O(N log N).
Surface unit_surface(ExtractedSurface extracted);

/// Its mirror image, with the same numbers.
Surface mirror_image(Surface surface);

/// In units in which it is `size` times as long.
Surface scaled(Surface surface, double size);

/// Area-weighted unit normals of the vertices.
std::vector<Point> unit_normals(const Mesh& mesh);

}  // namespace isomatch
