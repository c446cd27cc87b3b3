// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "geometry/closest_point.h"
#include "support/random.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

class WalkOnASphere : public testing::Test {
 protected:
  int any_face() { return random_.index(mesh_.num_faces()); }
  Point any_point() { return random_.uniform(0.8, 1.2) * random_.direction(); }

  Mesh mesh_ = test::icosphere(4);
  IndexLists faces_ = vertex_faces(mesh_);
  test::Random random_{1};
};

TEST_F(WalkOnASphere, EndsAtTheClosestOfAllVertices) {
  for (int trial = 0; trial < 200; ++trial) {
    const Point p = any_point();
    const auto distance = [&](const Point& vertex) { return (vertex - p).squaredNorm(); };
    const auto closest = std::ranges::min_element(mesh_.vertices, {}, distance);
    EXPECT_EQ(walk_to_vertex(mesh_, faces_, random_.index(mesh_.num_vertices()), p),
              closest - mesh_.vertices.begin());
  }
}

TEST_F(WalkOnASphere, StaysWhereNoNeighbourIsCloser) {
  for (int v = 0; v < mesh_.num_vertices(); ++v)
    EXPECT_EQ(walk_to_vertex(mesh_, faces_, v, 1.1 * mesh_.vertices[v]), v);
}

TEST_F(WalkOnASphere, EndsAtTheClosestPointOfAllFaces) {
  for (int trial = 0; trial < 50; ++trial) {
    const Point p = any_point();
    double least = 10;
    for (int f = 0; f < mesh_.num_faces(); ++f)
      least = std::min(least, closest_point(mesh_, f, p).squared_distance);
    const SurfacePoint found = walk_to_point(mesh_, faces_, std::array{any_face(), any_face()}, p);
    EXPECT_EQ((position(mesh_, found) - p).squaredNorm(), least);
  }
}

TEST_F(WalkOnASphere, WithoutAStartThereIsNoPoint) {
  EXPECT_EQ(walk_to_point(mesh_, faces_, {}, any_point()), SurfacePoint{});
}

}  // namespace
}  // namespace isomatch
