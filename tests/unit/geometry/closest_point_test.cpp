// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/closest_point.h"

#include <gtest/gtest.h>

#include <array>

#include "support/random.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

const Mesh kTriangle{{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

TEST(ClosestPoint, IsInsideOnAnEdgeOrAtACorner) {
  const auto closest = [](const Point& p) {
    return position(kTriangle, closest_point(kTriangle, 0, p).point);
  };
  // Some roundings of doubles near 1.
  constexpr double kRounding = 1e-15;
  EXPECT_LT((closest({0.5, 0.25, 3}) - Point(0.5, 0.25, 0)).norm(), kRounding);
  EXPECT_LT((closest({0.5, -4, 1}) - Point(0.5, 0, 0)).norm(), kRounding);
  EXPECT_LT((closest({2, 2, 0}) - Point(1.2, 0.4, 0)).norm(), kRounding);
  EXPECT_EQ(closest({-1, -1, 1}), kTriangle.vertices[0]);
  EXPECT_EQ(closest({5, -1, 0}), kTriangle.vertices[1]);
}

TEST(ClosestPoint, OfADegenerateFaceIsItsFirstCorner) {
  const Mesh mesh{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}}};
  const auto [point, squared_distance] = closest_point(mesh, 0, {1, 2, 5});
  EXPECT_EQ(position(mesh, point), mesh.vertices[0]);
  EXPECT_EQ(squared_distance, 4);
}

TEST(ClosestPointAround, IsTheBestOnTheFacesAround) {
  const Mesh mesh = test::rough_sphere(2, 0.3, 3);
  const IndexLists faces = vertex_faces(mesh);
  test::Random random(1);
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const Point p = mesh.vertices[v] + 0.3 * random.direction();
    double least = (mesh.vertices[v] - p).squaredNorm();
    for (int f : faces[v]) least = std::min(least, closest_point(mesh, f, p).squared_distance);
    const SurfacePoint found = closest_point_around(mesh, faces, v, p);
    EXPECT_EQ((position(mesh, found) - p).squaredNorm(), least);
  }
}

TEST(ClosestPointAround, IsTheVertexWhereNothingIsCloser) {
  const std::array<double, 3> corner{0, 1, 0};
  EXPECT_EQ(closest_point_around(kTriangle, vertex_faces(kTriangle), 1, {3, -1, 0}),
            (SurfacePoint{0, corner}));
}

}  // namespace
}  // namespace isomatch
