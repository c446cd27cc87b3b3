// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/picture/view.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "isomatch/mesh/synth.h"
#include "support/shapes.h"

namespace isomatch::picture {
namespace {

void expect_rotation(const Eigen::Matrix3d& matrix) {
  EXPECT_LT((matrix * matrix.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-9);
  EXPECT_NEAR(matrix.determinant(), 1, 1e-9);
}

TEST(View, AxesHaveNames) {
  EXPECT_EQ(parse_axis("y"), Point(0, 1, 0));
  EXPECT_EQ(parse_axis("-z"), Point(0, 0, -1));
  EXPECT_EQ(parse_axis("up"), std::nullopt);
  EXPECT_EQ(parse_axis(""), std::nullopt);
}

TEST(View, UpIsNeverTheThinnestDirection) {
  EXPECT_EQ(guess_up(test::box(4, {3, 5, 1})), Point::UnitY());
  EXPECT_EQ(guess_up(test::box(4, {5, 1, 3})), Point::UnitZ());
}

TEST(View, ABoxIsSeenFromItsLargestSide) {
  const Mesh wide = test::box(2, {5, 3, 1}), deep = test::box(2, {1, 3, 5});
  const Eigen::Matrix3d front = choose_view(wide, Point::UnitY(), 0);
  const Eigen::Matrix3d side = choose_view(deep, Point::UnitY(), 0);
  expect_rotation(front);
  expect_rotation(side);
  // The viewer stands before the large side and looks slightly down.
  EXPECT_GT(front(2, 2), 0.9);
  EXPECT_GT(front(2, 1), 0.1);
  EXPECT_GT(std::abs(side(2, 0)), 0.9);
  EXPECT_NEAR(front(0, 1), 0, 1e-12) << "up stays upright";
}

TEST(View, TurningTurnsAboutTheUprightAxis) {
  const Mesh mesh = test::box(2, {5, 3, 1});
  const Eigen::Matrix3d turned = choose_view(mesh, Point::UnitZ(), 90);
  expect_rotation(turned);
  EXPECT_NEAR(turned(0, 2), 0, 1e-12);
}

TEST(View, ThePoseOfASyntheticCreatureDoesNotPutItOnItsSide) {
  const auto creature = [](int pose) {
    return synthesize({.vertices = 1000, .pose = pose, .seed = 2}).mesh;
  };
  const Point up = guess_up(creature(0));
  for (int pose = 1; pose < 6; ++pose) EXPECT_EQ(guess_up(creature(pose)), up) << pose;
}

}  // namespace
}  // namespace isomatch::picture
