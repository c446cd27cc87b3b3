// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <vector>

#include "group/places.h"
#include "isomatch/shape/shape.h"
#include "shape/prepared_shape.h"
#include "support/context.h"
#include "support/shapes.h"

namespace isomatch::group {
namespace {

using test::icosphere;
using test::with_threads;

/// Spheres that are the same, between which the identity is right.
class Agreement : public testing::Test {
 protected:
  static constexpr int kShapes = 5;

  Agreement() : shape_(icosphere(3)), surface_(shape_.prepared().surface().get()) {
    right_ = corner_points(surface_->mesh);
    wrong_ = right_;
    for (std::size_t v = 0; v < wrong_.size(); ++v) wrong_[v] = right_[antipode(v)];
  }

  /// The vertex opposite: far from the right one.
  std::size_t antipode(std::size_t vertex) const {
    const std::vector<Point>& vertices = surface_->mesh.vertices;
    std::size_t farthest = 0;
    for (std::size_t v = 1; v < vertices.size(); ++v)
      if (vertices[v].dot(vertices[vertex]) < vertices[farthest].dot(vertices[vertex]))
        farthest = v;
    return farthest;
  }

  /// All pairs of shapes, both ways; `wrong` of them are.
  MapGraph graph(const std::vector<std::pair<int, int>>& wrong, double weight_of_wrong = 1) const {
    std::vector<WeightedMap> maps;
    for (int i = 0; i < kShapes; ++i) {
      for (int j = 0; j < kShapes; ++j) {
        if (i == j) continue;
        const bool is_wrong =
            std::ranges::count(wrong, std::pair(std::min(i, j), std::max(i, j))) > 0;
        maps.push_back({i, j, is_wrong ? &wrong_ : &right_, is_wrong ? weight_of_wrong : 1});
      }
    }
    return {std::vector<const Surface*>(kShapes, surface_), maps};
  }

  double error(const Places& places) const {
    double worst = 0;
    for (std::size_t v = 0; v < places.size(); ++v)
      worst = std::max(worst,
                       (position(surface_->mesh, places[v]) - surface_->mesh.vertices[v]).norm());
    return worst;
  }

  Shape shape_;
  const Surface* surface_;
  SurfaceMap right_, wrong_;
};

TEST_F(Agreement, OutvotesAWrongMapOfTheStar) {
  const MapGraph maps = graph({{0, 1}});
  std::vector<Places> places = maps.followed_from(0);
  ASSERT_GT(error(places[1]), 0.5);
  maps.agree(places, 0, 2, with_threads(2));
  EXPECT_LT(error(places[1]), 1e-3);
  EXPECT_GT(maps.disagreement(places, 0, 1, wrong_), 0.5);
  EXPECT_LT(maps.disagreement(places, 0, 2, right_), 1e-3);
}

TEST_F(Agreement, BeginsAlongTheMapsThatCountMost) {
  const MapGraph maps = graph({{0, 1}}, 0.1);
  EXPECT_LT(error(maps.followed_from(0)[1]), 1e-9);
}

TEST_F(Agreement, LeavesOutWhatMostMapsLeaveOut) {
  SurfaceMap part = right_;
  part[7] = {};
  std::vector<WeightedMap> maps;
  for (int i = 0; i < 3; ++i) maps.push_back({i, 3, i < 2 ? &part : &right_, 1});
  for (int i = 1; i < 3; ++i) maps.push_back({0, i, &right_, 1});
  const MapGraph graph(std::vector<const Surface*>(4, surface_), maps);
  std::vector<Places> places = graph.followed_from(0);
  graph.agree(places, 0, 1, with_threads(1));
  EXPECT_EQ(places[3][7].face, kNoFace);
  EXPECT_NE(places[3][8].face, kNoFace);
  EXPECT_NE(places[2][7].face, kNoFace);
}

TEST_F(Agreement, SpreadIsHowFarMapsAreApart) {
  // Both maps to shape 2 count the same, and lead to opposite points.
  const std::vector<WeightedMap> maps{{0, 1, &right_, 1}, {0, 2, &right_, 1}, {1, 2, &wrong_, 1}};
  const MapGraph graph(std::vector<const Surface*>(3, surface_), maps);
  const std::vector<Places> places{right_, right_, right_};
  const double diameter = 1 / std::sqrt(std::numbers::pi);  // Of a sphere of unit area.
  EXPECT_NEAR(graph.spread(places, 2)[0], diameter / std::numbers::sqrt2, 0.01);
  EXPECT_EQ(graph.spread(places, 0)[0], 0);
}

TEST_F(Agreement, WhatNoMapLeadsToHasNoPlaces) {
  const MapGraph graph(std::vector<const Surface*>(2, surface_), {});
  std::vector<Places> places = graph.followed_from(0);
  graph.agree(places, 0, 2, with_threads(1));
  EXPECT_EQ(places[1][0].face, kNoFace);
  EXPECT_EQ(error(places[0]), 0);
}

}  // namespace
}  // namespace isomatch::group
