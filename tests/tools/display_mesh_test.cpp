// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/display_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"

namespace isomatch::results {
namespace {

TEST(DisplayMesh, IsTheSameMeshRenumbered) {
  test::Random random(3);
  const Mesh mesh = test::relabelled(test::rough_sphere(3, 0.2, 1), random).mesh;
  const DisplayMesh display = display_mesh(mesh);
  EXPECT_FALSE(display.simplified);
  ASSERT_EQ(display.mesh.num_vertices(), mesh.num_vertices());
  for (int shown = 0; shown < display.mesh.num_vertices(); ++shown) {
    EXPECT_EQ(display.mesh.vertices[shown], mesh.vertices[display.input_vertex[shown]]);
    EXPECT_EQ(display.shown_vertex[display.input_vertex[shown]], shown);
  }
  const auto normal_form = [](Face face) {
    std::ranges::rotate(face, std::ranges::min_element(face));
    return face;
  };
  std::multiset<Face> given, shown;
  for (const Face& face : mesh.faces) given.insert(normal_form(face));
  for (const Face& face : display.mesh.faces)
    shown.insert(normal_form({display.input_vertex[face[0]], display.input_vertex[face[1]],
                              display.input_vertex[face[2]]}));
  EXPECT_EQ(given, shown);
}

TEST(DisplayMesh, NeighboursLieTogether) {
  test::Random random(3);
  const Mesh mesh = test::relabelled(test::icosphere(5), random).mesh;
  const DisplayMesh display = display_mesh(mesh);
  double step = 0;
  for (int v = 1; v < display.mesh.num_vertices(); ++v)
    step += (display.mesh.vertices[v] - display.mesh.vertices[v - 1]).norm();
  // Edges are about .04 long, random vertices 1.3 apart.
  EXPECT_LT(step / display.mesh.num_vertices(), 0.1);
}

TEST(DisplayMesh, TooManyVerticesAreSimplified) {
  const Mesh mesh = test::icosphere(5);
  const DisplayMesh display = display_mesh(mesh, 2000);
  EXPECT_TRUE(display.simplified);
  EXPECT_LE(display.mesh.num_vertices(), 2100);
  EXPECT_GE(display.mesh.num_vertices(), 1500);
  EXPECT_NEAR(surface_area(display.mesh) / surface_area(mesh), 1, 0.02);
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const int shown = display.shown_vertex[v];
    ASSERT_GE(shown, 0);
    EXPECT_LT((mesh.vertices[v] - display.mesh.vertices[shown]).norm(), 0.2);
  }
}

TEST(DisplayMesh, VerticesWithoutFacesStay) {
  Mesh mesh = test::icosphere(1);
  mesh.vertices.emplace_back(9, 9, 9);
  EXPECT_EQ(display_mesh(mesh).mesh.num_vertices(), mesh.num_vertices());
}

}  // namespace
}  // namespace isomatch::results
