// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/face_tree.h"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/closest_point.h"
#include "support/random.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

bool any_within(const Mesh& mesh, const Point& p, double distance) {
  for (int f = 0; f < mesh.num_faces(); ++f)
    if (closest_point(mesh, f, p).squared_distance <= distance * distance) return true;
  return false;
}

TEST(FaceTree, FindsWhatALookAtAllFacesFinds) {
  const Mesh mesh = test::rough_sphere(3, 0.3, 3);
  const FaceTree tree(mesh);
  test::Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Point p(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5));
    EXPECT_EQ(tree.is_within(p, 0.1), any_within(mesh, p, 0.1));
  }
}

TEST(FaceTree, LeavesOutWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}}, {{0, 1, 3}, {0, 1, 2}}};
  EXPECT_TRUE(FaceTree(mesh).is_within({0.2, 0.2, 0.1}, 0.2));
  EXPECT_FALSE(FaceTree(mesh).is_within({0.2, 0.2, 0.3}, 0.2));
  EXPECT_FALSE(FaceTree({mesh.vertices, {{0, 1, 3}}}).is_within({0, 0, 0}, 1));
}

}  // namespace
}  // namespace isomatch
