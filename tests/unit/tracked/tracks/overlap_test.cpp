// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "support/random.h"
#include "support/shapes.h"
#include "unit/tracked/prepared.h"

namespace isomatch::tracked {
namespace {

/// A sheet of [-.5, .5] x [-.5, .5] of which the left half is inside.
class SheetTest : public testing::Test {
 protected:
  static bool is_left(const Point& p) { return p.x() < 0.01; }

  /// Turns over what is as close to a place as this.
  void turn(const Point& place, double radius) {
    for (std::size_t i = 0; i < inside_.size(); ++i)
      if ((graph_.cloud.positions[i] - place).norm() < radius) inside_[i] = !inside_[i];
  }

  std::vector<bool> result(const PartialOptions& options = {}) const {
    return smoothed(inside_, graph_.cloud.areas, graph_.neighbours, options);
  }

  /// That all are as they were at first, but for those beside the border of the halves.
  void expect_left_half(const std::vector<bool>& inside) const {
    ASSERT_EQ(inside.size(), inside_.size());
    for (std::size_t i = 0; i < inside.size(); ++i) {
      const Point& p = graph_.cloud.positions[i];
      if (std::abs(p.x()) > 0.11) {
        EXPECT_EQ(inside[i], is_left(p)) << p.transpose();
      }
    }
  }

  void SetUp() override {
    for (const Point& p : graph_.cloud.positions) inside_.push_back(is_left(p));
  }

  const test::Prepared sheet_{test::sheet(20, 20)};
  const NodeGraph graph_ = node_graph(sheet_.proxy, 441);
  std::vector<bool> inside_;
};

TEST_F(SheetTest, SmoothingKeepsAHalf) { expect_left_half(result()); }

TEST_F(SheetTest, SmoothingDropsASmallPiece) {
  turn({0.3, 0, 0}, 0.08);
  expect_left_half(result());
}

TEST_F(SheetTest, SmoothingFillsAPinhole) {
  turn({-0.3, 0, 0}, 0.03);
  turn({-0.2, 0.3, 0}, 0.03);
  expect_left_half(result());
}

TEST_F(SheetTest, PiecesAreDroppedBySize) {
  const std::vector<bool> half = inside_;
  turn({0.3, 0, 0}, 0.08);
  const PartialOptions keeping{.smoothing = 0, .min_piece = 0}, dropping{.smoothing = 0};
  EXPECT_EQ(result(keeping), inside_);
  EXPECT_EQ(result(dropping), half);
}

TEST_F(SheetTest, OfNothingNothingIsLeft) {
  inside_.assign(inside_.size(), false);
  EXPECT_EQ(result(), inside_);
  inside_.assign(inside_.size(), true);
  EXPECT_EQ(result(), inside_);
}

TEST_F(SheetTest, OverlapsGrowByWhatMetTheSurfaceBesideThem) {
  elastic::PointCloud cloud = graph_.cloud;
  elastic::Registration registration;
  registration.met.assign(inside_.size(), true);
  Options options;
  options.parts = true;
  EXPECT_TRUE(inside_after(cloud, graph_.neighbours, registration, options).empty());
  cloud.inside = inside_;
  const auto count = [](const std::vector<bool>& inside) {
    return std::ranges::count(inside, true);
  };
  const std::vector<bool> grown = inside_after(cloud, graph_.neighbours, registration, options);
  EXPECT_GE(count(grown), count(inside_));
  for (std::size_t i = 0; i < grown.size(); ++i)
    if (grown[i]) {
      EXPECT_LT(graph_.cloud.positions[i].x(), 0.11);
    }
  registration.met.assign(inside_.size(), false);
  EXPECT_EQ(count(inside_after(cloud, graph_.neighbours, registration, options)), 0);
}

TEST_F(SheetTest, RigidMotionIsContinuedExactly) {
  test::Random random(1);
  const Eigen::Matrix3d rotation = random.rotation();
  const Point shift = random.direction();
  elastic::PointCloud cloud = graph_.cloud;
  cloud.inside = inside_;
  std::vector<Point> anchors(cloud.positions.size(), Point(7, 7, 7));
  for (std::size_t i = 0; i < anchors.size(); ++i)
    if (inside_[i]) anchors[i] = rotation * cloud.positions[i] + shift;
  carry_outside(cloud, anchors);
  for (std::size_t i = 0; i < anchors.size(); ++i)
    EXPECT_LT((anchors[i] - (rotation * cloud.positions[i] + shift)).norm(), 1e-9);
}

TEST_F(SheetTest, WhereNothingIsInsideAnchorsStay) {
  elastic::PointCloud cloud = graph_.cloud;
  cloud.inside.assign(cloud.positions.size(), false);
  std::vector<Point> anchors = cloud.positions;
  carry_outside(cloud, anchors);
  EXPECT_EQ(anchors, cloud.positions);
}

TEST_F(SheetTest, FewPointsInsideCarryAllOthersSomewhere) {
  elastic::PointCloud cloud = graph_.cloud;
  for (const int count : {1, 2, 3}) {
    cloud.inside.assign(cloud.positions.size(), false);
    std::fill_n(cloud.inside.begin(), count, true);
    std::vector<Point> anchors = cloud.positions;
    carry_outside(cloud, anchors);
    for (const Point& p : anchors) EXPECT_TRUE(p.allFinite());
  }
}

constexpr PyramidOptions kSmall{.detail_vertices = 800,
                                .proxy = {.vertices = 800, .nodes = 200},
                                .coarse_nodes = 50,
                                .middle_nodes = 100,
                                .functions = 20};

Pyramid small_pyramid(const Mesh& mesh, const View& view) {
  return make_pyramid(PreparedShape(mesh, {}), view, kSmall, {});
}

/// Five points in a row, of which the last two may be left out.
class LeftOut : public testing::Test {
 protected:
  double result() const { return left_out({inside_, by_rim_, areas_, row_}, options_); }

  const PartialOptions options_;
  const std::vector<double> areas_{1, 2, 3, 4, 5};
  const IndexLists row_{{0, 1, 3, 5, 7, 8}, {1, 0, 2, 1, 3, 2, 4, 3}};
  std::vector<bool> inside_{true, true, true, false, false};
  std::vector<bool> by_rim_ = std::vector<bool>(5, false);
};

TEST_F(LeftOut, IsNothingWhereAllIsInside) {
  inside_.assign(5, true);
  EXPECT_EQ(result(), 0);
}

TEST_F(LeftOut, IsTheAreaOfAPieceThatBeginsByTheRim) {
  by_rim_[3] = true;
  EXPECT_DOUBLE_EQ(result(), 9);
}

TEST_F(LeftOut, CostsMoreWhereNothingTellsWhy) {
  by_rim_[4] = true;  // Not where the piece begins.
  EXPECT_DOUBLE_EQ(result(), options_.contradiction_price * 9);
}

TEST_F(LeftOut, OfAllHasNoBorderThatTellsWhy) {
  inside_.assign(5, false);
  by_rim_.assign(5, true);
  EXPECT_DOUBLE_EQ(result(), options_.contradiction_price * 15);
}

TEST(Part, OfEverythingHasTheEigenvaluesOfTheWhole) {
  const Pyramid whole = small_pyramid(synthesize({.vertices = 1000, .pose = 1}).mesh, {});
  const Part part = part_of_proxy(whole.proxy, whole.middle,
                                  std::vector<bool>(whole.middle.size(), true), 20, {});
  ASSERT_EQ(std::ssize(part.vertex), whole.proxy.num_vertices());
  ASSERT_EQ(part.basis.values.size(), whole.basis.values.size());
  for (int k = 0; k < part.basis.values.size(); ++k)
    EXPECT_NEAR(part.basis.values[k], whole.basis.values[k], 1e-3 * (1 + whole.basis.values[k]));
  for (int row = 0; row < static_cast<int>(part.vertex.size()); ++row)
    EXPECT_EQ(part.row[part.vertex[row]], row);
}

TEST(Part, OfHalfIsSmallerAndOfNothingEmpty) {
  const Pyramid whole = small_pyramid(test::sheet(20, 20), {});
  std::vector<bool> inside;
  for (const Point& p : whole.middle.graph.cloud.positions) inside.push_back(p.x() < 0);
  const Part half = part_of_proxy(whole.proxy, whole.middle, inside, 20, {});
  EXPECT_FALSE(half.empty());
  EXPECT_EQ(half.basis.functions.rows(), std::ssize(half.vertex));
  for (int v : half.vertex) EXPECT_LT(whole.proxy.mesh.vertices[v].x(), 0.15);
  const Part none =
      part_of_proxy(whole.proxy, whole.middle, std::vector<bool>(inside.size(), false), 20, {});
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(std::ssize(none.row), whole.proxy.num_vertices());
}

/// Nodes of a shape on themselves, of which those on one side are inside.
TEST(Overlap, IsRefinedOntoItself) {
  const Pyramid whole = small_pyramid(synthesize({.vertices = 1000, .pose = 1}).mesh, {});
  const Level& level = whole.middle;
  std::vector<bool> inside;
  std::vector<int> nearest;
  for (int i = 0; i < level.size(); ++i) {
    inside.push_back(whole.proxy.node_position(i).z() > 0);
    nearest.push_back(i);
  }
  const std::vector<int> vertices = node_vertices(whole.proxy, nearest);
  const Overlap overlap{part_of_proxy(whole.proxy, level, inside, 20, {}),
                        part_of_proxy(whole.proxy, level, inside, 20, {})};
  const std::vector<int> refined = refine_on_overlap(
      overlap, whole.proxy, whole.proxy, {level, level, inside, vertices, nearest}, level, 15, {});
  ASSERT_EQ(std::ssize(refined), level.size());
  int matched = 0;
  double sum = 0;
  for (int i = 0; i < level.size(); ++i) {
    if (refined[i] == kNoVertex) continue;
    sum += (whole.proxy.mesh.vertices[refined[i]] - whole.proxy.node_position(i)).norm();
    ++matched;
  }
  EXPECT_LT(sum / matched, 0.02);
  EXPECT_GT(matched, level.size() / 4);
  EXPECT_LT(matched, level.size());
}

}  // namespace
}  // namespace isomatch::tracked
