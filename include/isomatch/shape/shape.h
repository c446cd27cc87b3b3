// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "isomatch/context.h"
#include "isomatch/geodesics/geodesics.h"
#include "isomatch/mesh/mesh.h"
#include "isomatch/shape/diagnosis.h"

namespace isomatch {

class PreparedShape;

/// A mesh prepared for matching and measuring, to be kept and used in many pairs. Whatever takes or
/// gives vertices and faces of a shape counts them as its mesh does.
///
/// What is matched is its surface: the connected component of largest area, without degenerate
/// faces (a repeated vertex, or an area that is zero up to the rounding of the coordinates),
/// without duplicate faces (the same three vertices as a face of lower index), without faces that
/// have a vertex that is not finite or stray (see `MeshDiagnosis`), and without unreferenced
/// vertices. It may have boundaries, non-manifold edges and vertices, and inconsistently oriented
/// faces. Seams of split vertices, as in files with texture coordinates, are closed where boundary
/// edges coincide exactly, so that several vertices of the mesh may be one place of the surface.
/// The other vertices have no match.
///
/// Inside, the surface is scaled to unit area. What matching and measuring need besides (geodesic
/// graph, largest distance, simplified copies, eigenfunctions) is computed when it is first needed,
/// and kept: some 30 MB for a shape of 5,000 vertices that was matched. A copy shares all of it.
/// Safe to use from several threads, of which one waits while another one computes the same.
class Shape {
 public:
  /// `geodesics` is for the paper's method and for measures; the tracked method has its own. Throws
  /// `InvalidInput` if `mesh` fails `validate`, has a coordinate beyond 1e100, or has no face of
  /// positive area. O(N log N).
  explicit Shape(Mesh mesh, const GeodesicOptions& geodesics = {});

  const Mesh& mesh() const;
  int num_vertices() const { return mesh().num_vertices(); }
  const MeshDiagnosis& diagnosis() const;
  /// Of the surface, in squared units of the mesh.
  double area() const;
  /// Vertices of the surface.
  int num_surface_vertices() const;
  /// Whether a vertex is part of the surface. Throws `InvalidInput` if there is no such vertex.
  bool on_surface(int vertex) const;
  /// The vertices that are the same place of the surface, ascending, with `vertex` itself; none if
  /// it is not part of it. Valid as long as a copy of the shape lives. Throws `InvalidInput` if
  /// there is no such vertex.
  std::span<const int> copies(int vertex) const;
  /// The largest geodesic distance on the surface, in units of the mesh, see `geodesic_diameter`.
  double max_geodesic(const Context& context = {}) const;

  /// What the library knows of it.
  const PreparedShape& prepared() const { return *prepared_; }

 private:
  std::shared_ptr<const PreparedShape> prepared_;
};

/// What matching keeps with a shape of so many vertices, about and rather more than less, in bytes:
/// docs/results/batch_memory.md has what it was for shapes of 5,000 to 100,000 vertices.
std::uint64_t kept_bytes(int num_vertices);

}  // namespace isomatch
