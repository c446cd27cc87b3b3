// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "isomatch/mesh/mesh.h"

/// Meshes with one peculiarity each. Spheres are icospheres of radius 1 with 162 vertices and 320
/// faces (two subdivisions) unless noted.
namespace isomatch::test {

/// A sphere without its face 0: one boundary loop of three edges.
Mesh sphere_with_hole();

/// A sphere with one more face on an inner edge, up to a new vertex: one edge of three faces.
Mesh sphere_with_fin();

/// Two spheres of radius 1 and 0.5 that share vertex 0 and nothing else.
Mesh bow_tie();

/// Three spheres of radius 0.25, 1 and 0.5 that do not touch, in this order; 162 vertices each.
Mesh three_spheres();

/// A sphere with four degenerate faces after the others: two with a repeated vertex, two with three
/// corners on a line, one of them with vertices of its own.
Mesh sphere_with_degenerate_faces();

/// A sphere with copies of faces 5, 6 and 7 after the others: equal, rotated, and turned over.
Mesh sphere_with_duplicate_faces();

/// A sphere with two vertices before and three after its own that no face uses.
Mesh sphere_with_unreferenced_vertices();

/// A sphere whose faces 0, 10, 20, ... are turned over.
Mesh sphere_with_flipped_faces();

/// A sphere cut by the coordinate planes into eight charts with vertices of their own.
Mesh sphere_of_charts();

/// A flat sheet of 4 x 4 cells and a copy of it, turned over, at exactly the same place.
Mesh two_sided_sheet();

/// Three sheets of 4 x 4 cells with vertices of their own that meet along one straight line.
Mesh three_sheets_on_a_line();

/// Two flat sheets with vertices of their own, areas 1 and 0.25, that touch in one corner only.
Mesh sheets_touching_in_a_point();

struct ZooMesh {
  std::string name;
  Mesh mesh;
};

/// Lets GoogleTest name the mesh instead of printing its bytes.
inline std::ostream& operator<<(std::ostream& stream, const ZooMesh& zoo_mesh) {
  return stream << zoo_mesh.name;
}

/// All of the above and the sound shapes of shapes.h, for tests that must hold on any mesh.
std::vector<ZooMesh> mesh_zoo();

}  // namespace isomatch::test
