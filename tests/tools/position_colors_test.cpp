// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/picture/position_colors.h"

#include <gtest/gtest.h>

#include "isomatch/error.h"
#include "support/shapes.h"

namespace isomatch::picture {
namespace {

TEST(Oklab, WhiteBlackAndRed) {
  EXPECT_LT((from_oklab(1, 0, 0) - Color(1, 1, 1)).norm(), 1e-3);
  EXPECT_LT(from_oklab(0, 0, 0).norm(), 1e-6);
  // Oklab of the sRGB red, from its definition.
  EXPECT_LT((from_oklab(0.62796F, 0.22486F, 0.12585F) - Color(1, 0, 0)).norm(), 1e-3);
}

TEST(PositionColors, AxesAreSortedByExtent) {
  const Mesh mesh = test::box(4, {1, 5, 3});
  const PositionColors colors(Eigen::Matrix3d::Identity(), mesh.vertices);
  EXPECT_EQ(colors.axes().row(0).transpose(), Point::UnitY());
  EXPECT_EQ(colors.axes().row(1).transpose(), Point::UnitZ());
  EXPECT_EQ(colors.size(), Point(5, 3, 1));
  EXPECT_EQ(colors.low(), Point(0, 0, 0));
}

TEST(PositionColors, EveryDirectionChangesTheColour) {
  const Mesh mesh = test::box(4, {1, 5, 3});
  const PositionColors color(Eigen::Matrix3d::Identity(), mesh.vertices);
  const Color middle = color({0.5, 2.5, 1.5});
  EXPECT_GT((color({0.9, 2.5, 1.5}) - middle).norm(), 0.1);
  EXPECT_GT((color({0.5, 4.5, 1.5}) - middle).norm(), 0.1);
  EXPECT_GT((color({0.5, 2.5, 2.7}) - middle).norm(), 0.1);
  EXPECT_EQ(color({0.5, 99, 1.5}), color({0.5, 5, 1.5}));
}

TEST(PositionColors, FlatAndSinglePointsHaveAColour) {
  const std::vector<Point> point{{1, 2, 3}};
  EXPECT_TRUE(PositionColors(Eigen::Matrix3d::Identity(), point)(point[0]).allFinite());
  EXPECT_THROW(PositionColors(Eigen::Matrix3d::Identity(), std::vector<Point>{}), InvalidInput);
}

}  // namespace
}  // namespace isomatch::picture
