// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/maps/surface_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace isomatch {
namespace {

using testing::ElementsAre;

TEST(SurfacePoint, LiesWhereItsWeightsSay) {
  const Mesh sheet = test::sheet(1, 1, 4, 2);
  const auto& [a, b, c] = sheet.faces[1];
  const Point expected =
      0.5 * sheet.vertices[a] + 0.25 * sheet.vertices[b] + 0.25 * sheet.vertices[c];
  EXPECT_EQ(position(sheet, {1, {0.5, 0.25, 0.25}}), expected);
  EXPECT_EQ(position(sheet, {1, {0, 0, 1}}), sheet.vertices[c]);
}

TEST(NearestVertices, HaveTheLargestWeight) {
  const Mesh sheet = test::sheet(1, 1);
  const Face& face = sheet.faces[1];
  EXPECT_THAT(nearest_vertices(sheet, {{1, {0.2, 0.2, 0.6}}, {}, {1, {0.25, 0.375, 0.375}}}),
              ElementsAre(face[2], kUnmatched, face[1]));
}

TEST(CornerPoints, ArePointsAtTheVertices) {
  Mesh sheet = test::sheet(2, 1);
  sheet.vertices.emplace_back(5, 5, 5);
  const SurfaceMap points = corner_points(sheet);
  ASSERT_EQ(points.size(), 7);
  for (int v = 0; v < 6; ++v) EXPECT_EQ(position(sheet, points[v]), sheet.vertices[v]);
  EXPECT_EQ(points[6], SurfacePoint{});
  const SurfaceMap images = corner_points(sheet, {4, kUnmatched, 6, 0});
  EXPECT_THAT(images, ElementsAre(points[4], SurfacePoint{}, SurfacePoint{}, points[0]));
}

}  // namespace
}  // namespace isomatch
