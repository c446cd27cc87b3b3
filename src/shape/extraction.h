// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/topology.h"
#include "shape/sound_mesh.h"

namespace isomatch {

/// The part of a mesh that matching works on, in the mesh's own coordinates, renumbered for
/// locality.
///
/// `mesh` is the connected component of largest area, without degenerate faces (a repeated vertex,
/// or an area that is zero up to the rounding of the coordinates), without duplicate faces (the
/// same three vertices as a face of lower index), without faces that have a vertex that is not
/// finite or stray (see `MeshDiagnosis`), and without unreferenced vertices. It may have
/// boundaries, non-manifold edges and vertices, and inconsistently oriented faces. Every vertex has
/// a face.
///
/// Boundary edges whose ends coincide exactly with those of one other boundary edge are joined
/// before components are told apart, so that several input vertices may share one surface vertex: a
/// seam of split vertices, as in files with texture coordinates, closes, and loose triangles become
/// a surface. An edge stays open where more than two boundary edges coincide, where the two faces
/// coincide (a sheet and its copy), or where joining would make an edge of more than two faces.
struct ExtractedSurface {
  Mesh mesh;
  /// Surface vertex to input vertex, the lowest of those that lead to it.
  std::vector<int> input_vertex;
  /// Input vertex to surface vertex, `kNoVertex` where it is not part of the surface. A vertex
  /// without a face that has an area goes with a coinciding vertex of the surface, if there is one.
  std::vector<int> surface_vertex;
  /// Surface face to input face. The corners keep their order, so barycentric coordinates
  /// carry over.
  std::vector<int> input_face;
  int num_input_faces = 0;
  /// Area of `mesh`, and of all components together, each duplicate face counted once.
  double area = 0, total_area = 0;
  /// Of the whole input: connected components after joining, of which `mesh` is one.
  int components = 0;
  /// Of the whole input: faces left out, and pairs of boundary edges joined.
  int degenerate_faces = 0, duplicate_faces = 0, joined_edges = 0;

  int num_vertices() const { return mesh.num_vertices(); }
};

/// Extracts the matchable surface of `input`, vertices and faces numbered along a Hilbert curve,
/// which makes geodesics on a million vertices two to three times as fast. Of duplicate faces and
/// of coinciding vertices the lowest counts, of components of equal area the first along the curve.
/// Throws `InvalidInput` if `input` fails `validate`, has a coordinate beyond 1e100, or has no face
/// of positive area. O(N log N).
ExtractedSurface extract_surface(const Mesh& input);

/// The second half of `extract_surface`: joins seams and picks the largest component. `sound` has
/// at least one face.
ExtractedSurface largest_surface(SoundMesh sound);

}  // namespace isomatch
