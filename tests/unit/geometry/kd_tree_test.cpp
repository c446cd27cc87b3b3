// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/kd_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <span>

#include "support/random.h"

namespace isomatch {
namespace {

/// All indices, nearest first, by brute force.
template <int Dimension>
std::vector<int> by_distance(const std::vector<Eigen::Matrix<double, Dimension, 1>>& points,
                             const Eigen::Matrix<double, Dimension, 1>& query) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) {
    double sum = 0;
    for (int k = 0; k < Dimension; ++k)
      sum += (points[i][k] - query[k]) * (points[i][k] - query[k]);
    return sum;
  });
  return order;
}

/// On a coarse grid many points are equally near, and some coincide.
template <int Dimension>
void expect_the_nearest(int steps) {
  using Coordinates = Eigen::Matrix<double, Dimension, 1>;
  test::Random random(Dimension);
  const auto any = [&] {
    Coordinates point;
    for (int k = 0; k < Dimension; ++k) point[k] = random.index(steps);
    return point;
  };
  std::vector<Coordinates> points(500);
  std::ranges::generate(points, any);
  const KdTree<Dimension> tree(points);
  for (int trial = 0; trial < 200; ++trial) {
    const Coordinates query = any();
    const std::vector<int> expected = by_distance<Dimension>(points, query);
    EXPECT_EQ(tree.nearest(query), expected[0]);
    std::array<int, 7> found{};
    EXPECT_EQ(tree.nearest(query, found), found.size());
    EXPECT_TRUE(std::ranges::equal(found, std::span(expected).first(found.size())));
  }
}

TEST(KdTree, FindsTheNearest) {
  expect_the_nearest<3>(1 << 20);
  expect_the_nearest<6>(1 << 20);
}

TEST(KdTree, OfEquallyNearPointsTheLowerIndexCounts) {
  expect_the_nearest<3>(5);
  expect_the_nearest<6>(2);
}

TEST(KdTree, TellsHowManyThereAre) {
  const std::vector<Point> points{{1, 0, 0}, {0, 0, 0}}, none;
  std::array<int, 4> found{};
  EXPECT_EQ(KdTree<3>(points).nearest({0, 0, 0}, found), 2U);
  EXPECT_EQ(found, (std::array{1, 0, 0, 0}));
  EXPECT_EQ(KdTree<3>(none).nearest({0, 0, 0}, found), 0U);
  EXPECT_EQ(KdTree<3>(points).nearest({0, std::nan(""), 0}), 0);
}

}  // namespace
}  // namespace isomatch
