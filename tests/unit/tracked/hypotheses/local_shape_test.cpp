// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/local_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "support/random.h"
#include "support/shapes.h"
#include "unit/tracked/prepared.h"

namespace isomatch::tracked {
namespace {

constexpr int kRingsOfTwoRadii = 6;

FloatMatrix shapes_of(const Mesh& mesh, int count) {
  std::vector<int> nodes(count);
  std::iota(nodes.begin(), nodes.end(), 0);
  return local_shapes(test::Prepared(mesh).proxy, nodes, {});
}

TEST(LocalShapes, HaveAHistogramARing) {
  const FloatMatrix shapes = shapes_of(synthesize({.vertices = 1500, .pose = 1}).mesh, 20);
  const Eigen::Index bins = shapes.cols() / kRingsOfTwoRadii;
  ASSERT_EQ(shapes.cols(), bins * kRingsOfTwoRadii);
  EXPECT_GE(shapes.minCoeff(), 0);
  for (Eigen::Index node = 0; node < shapes.rows(); ++node)
    for (Eigen::Index ring = 0; ring < kRingsOfTwoRadii; ++ring)
      EXPECT_NEAR(shapes.row(node).segment(ring * bins, bins).sum(), 1, 1e-4);
}

TEST(LocalShapes, DoNotDependOnHowAShapeLiesNorOnItsSize) {
  const Mesh mesh = synthesize({.vertices = 1500, .pose = 1}).mesh;
  test::Random random(4);
  Mesh moved = mesh;
  const Eigen::Matrix3d rotation = random.rotation();
  for (Point& p : moved.vertices) p = 7 * (rotation * p) + Point(3, -2, 1);
  EXPECT_LT((shapes_of(mesh, 50) - shapes_of(moved, 50)).cwiseAbs().maxCoeff(), 1e-2);
}

TEST(LocalShapes, OfASphereAreAlikeAndOfACreatureAreNot) {
  const auto spread = [](const FloatMatrix& shapes) {
    float most = 0;
    for (Eigen::Index i = 1; i < shapes.rows(); ++i)
      most = std::max(most, (shapes.row(i) - shapes.row(0)).lpNorm<1>());
    return most;
  };
  const float sphere = spread(shapes_of(test::icosphere(3), 20));
  EXPECT_LT(sphere, 1);
  EXPECT_GT(spread(shapes_of(synthesize({.vertices = 1500, .pose = 1}).mesh, 20)), 3 * sphere);
}

}  // namespace
}  // namespace isomatch::tracked
