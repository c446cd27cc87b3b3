// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/boundary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/shapes.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

TEST(Boundary, OfASheetIsItsRim) {
  const Mesh mesh = test::sheet(4, 3, 2, 1);
  const std::vector<int> vertices = boundary_vertices(mesh);
  EXPECT_TRUE(std::ranges::is_sorted(vertices));
  EXPECT_EQ(std::ssize(vertices), 2 * (4 + 3));
  for (int v : vertices) {
    const Point& p = mesh.vertices[v];
    EXPECT_TRUE(p.x() == 0 || p.x() == 2 || p.y() == 0 || p.y() == 1);
  }
  EXPECT_NEAR(boundary_length(mesh), 6, 1e-12);
}

TEST(Boundary, OfClosedShapesIsEmpty) {
  for (const Mesh& mesh : {test::icosphere(2), test::torus(24, 12), test::box(3)}) {
    EXPECT_TRUE(boundary_vertices(mesh).empty());
    EXPECT_EQ(boundary_length(mesh), 0);
  }
}

TEST(Boundary, HasAllLoops) {
  const Mesh mesh = test::open_cylinder(16, 8);
  EXPECT_EQ(std::ssize(boundary_vertices(mesh)), 2 * 16);
  EXPECT_NEAR(boundary_length(mesh), 2 * 2 * 16 * std::sin(std::numbers::pi / 16), 1e-12);
}

TEST(Boundary, OfAHoleIsThatOfTheFaceThatIsMissing) {
  EXPECT_EQ(std::ssize(boundary_vertices(test::sphere_with_hole())), 3);
}

TEST(Boundary, HasNoEdgesOfThreeFaces) {
  // Of the fin two edges have one face; the inner edge has three.
  const Mesh mesh = test::sphere_with_fin();
  EXPECT_EQ(std::ssize(boundary_vertices(mesh)), 3);
  EXPECT_GT(boundary_length(mesh), 0);
}

}  // namespace
}  // namespace isomatch
