// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace isomatch {

using Point = Eigen::Vector3d;
/// Three vertex indices, 0-based.
using Face = std::array<int, 3>;

/// An indexed triangle mesh, exactly as it was given: nothing is merged, reordered or dropped, and
/// it may have any defect that `diagnose` lists.
struct Mesh {
  std::vector<Point> vertices;
  std::vector<Face> faces;

  int num_vertices() const { return static_cast<int>(vertices.size()); }
  int num_faces() const { return static_cast<int>(faces.size()); }
};

/// Throws `InvalidInput` if `mesh` has no vertices or faces, or an index out of range. Coordinates
/// may be infinite or not a number, as in 7 of 62 published scans of skulls: such vertices are no
/// part of the surface. O(N).
void validate(const Mesh& mesh);

/// The same, and that all coordinates are finite.
void validate_finite(const Mesh& mesh);

/// Area of face `face`, in squared units of the coordinates.
double face_area(const Mesh& mesh, int face);

/// Sum of all face areas.
double surface_area(const Mesh& mesh);

/// A third of the area of the faces around each vertex: N values that sum to `surface_area`.
std::vector<double> vertex_areas(const Mesh& mesh);

/// At each vertex the sum of the normals of the faces around it, each as long as twice the area of
/// its face.
std::vector<Point> weighted_vertex_normals(const Mesh& mesh);

}  // namespace isomatch
