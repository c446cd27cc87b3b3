// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/mesh.h"
#include "support/random.h"

namespace isomatch::test {

/// `mesh` rotated at random and moved by ten times its size.
Mesh moved(const Mesh& mesh, Random& random);

/// `mesh` with all coordinates times `factor`.
Mesh scaled(const Mesh& mesh, double factor);

/// `mesh` with its coordinates as 32 bits hold them.
Mesh rounded_to_float(Mesh mesh);

/// `mesh` reflected in the plane x = 0, the faces turned so that they still face outwards.
Mesh mirrored(const Mesh& mesh);

/// The same mesh under other vertex and face numbers, the corners of each face rotated at random.
struct Relabelled {
  Mesh mesh;
  /// New number of each old vertex and face.
  std::vector<int> new_vertex, new_face;
};
Relabelled relabelled(const Mesh& mesh, Random& random);

/// Both meshes in one, the vertices and faces of `b` after those of `a`.
Mesh combined(const Mesh& a, const Mesh& b);

/// Every triangle with three vertices of its own, as in an STL file: vertex 3 f + c is corner c of
/// face f.
Mesh soup(const Mesh& mesh);

/// Splits vertices so that faces share a vertex only if `chart` gives them the same number, as a
/// texture atlas does. The first chart in face order keeps the vertex, copies go to the end.
Mesh split_charts(const Mesh& mesh, const std::vector<int>& chart);

/// For each face the octant (0 to 7) in which its centre of gravity lies.
std::vector<int> octants(const Mesh& mesh);

}  // namespace isomatch::test
