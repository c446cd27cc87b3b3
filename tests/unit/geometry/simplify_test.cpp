// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/shapes.h"

namespace isomatch {
namespace {

TEST(Simplify, KeepsSomeOfTheVerticesInOrder) {
  const Mesh mesh = test::rough_sphere(4, 0.1, 1);
  const SimplifiedMesh simplified = simplify(mesh, 300);
  EXPECT_NO_THROW(validate(simplified.mesh));
  EXPECT_NEAR(simplified.mesh.num_vertices(), 300, 10);
  EXPECT_TRUE(std::ranges::is_sorted(simplified.kept));
  for (int v = 0; v < simplified.mesh.num_vertices(); ++v)
    EXPECT_EQ(simplified.mesh.vertices[v], mesh.vertices[simplified.kept[v]]);
}

TEST(Simplify, LeavesASmallMeshAsItIs) {
  const Mesh mesh = test::icosphere(2);
  const SimplifiedMesh simplified = simplify(mesh, mesh.num_vertices());
  EXPECT_EQ(simplified.mesh.vertices, mesh.vertices);
  EXPECT_EQ(simplified.mesh.faces, mesh.faces);
}

TEST(SimplifiedFaces, AreThoseOfTheSimplifiedMesh) {
  const Mesh mesh = test::rough_sphere(3, 0.1, 1);
  const SimplifiedMesh simplified = simplify(mesh, 200);
  std::vector<Face> faces = simplified.mesh.faces;
  for (Face& face : faces)
    for (int& v : face) v = simplified.kept[v];
  EXPECT_EQ(simplified_faces(mesh, 200), faces);
}

}  // namespace
}  // namespace isomatch
