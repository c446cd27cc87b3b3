// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

using testing::ElementsAre;

/// Distances are sums of floats: relative error of some 1e-6.
constexpr double kRounding = 1e-5;

constexpr int kColumns = 20, kRows = 10;
constexpr double kWidth = 2, kHeight = 1;
constexpr double kCell = kWidth / kColumns;

int sheet_vertex(int column, int row) { return row * (kColumns + 1) + column; }

/// A flat sheet and itself.
class SheetErrors : public testing::Test {
 protected:
  GroundTruth identity_truth() const {
    std::vector<int> all(sheet_.num_vertices());
    std::iota(all.begin(), all.end(), 0);
    return {all, all};
  }

  /// Every vertex to the one `columns` to the right of it, where there is one.
  Correspondence shift(int columns) const {
    Correspondence matches;
    for (int row = 0; row <= kRows; ++row) {
      for (int column = 0; column + columns <= kColumns; ++column)
        matches.push_back({sheet_vertex(column, row), sheet_vertex(column + columns, row)});
    }
    return matches;
  }

  const Shape sheet_{test::sheet(kColumns, kRows, kWidth, kHeight)};
  const double sqrt_area_ = std::sqrt(kWidth * kHeight);
};

TEST_F(SheetErrors, IdentityHasNone) {
  const ErrorStatistics errors = template_errors(sheet_, sheet_, identity_truth(), shift(0));
  EXPECT_EQ(errors.samples, sheet_.num_vertices());
  EXPECT_EQ(errors.maximum, 0);
  EXPECT_EQ(match_errors(sheet_, sheet_, identity_truth(), shift(0)).maximum, 0);
}

TEST_F(SheetErrors, ShiftHasItsLengthEverywhere) {
  const ErrorStatistics errors = template_errors(sheet_, sheet_, identity_truth(), shift(3));
  EXPECT_EQ(errors.samples, (kColumns - 2) * (kRows + 1));
  for (double error : {errors.mean, errors.median, errors.p95, errors.maximum})
    EXPECT_NEAR(error, 3 * kCell / sqrt_area_, kRounding);
}

TEST_F(SheetErrors, MatchErrorsAreRelativeToDiagonal) {
  const ErrorStatistics errors = match_errors(sheet_, sheet_, identity_truth(), shift(3));
  EXPECT_EQ(errors.samples, (kColumns - 2) * (kRows + 1));
  // The visibility graph's diagonal may be longer than the straight line by its error of .2 %.
  const double expected = 3 * kCell / std::hypot(kWidth, kHeight);
  EXPECT_NEAR(errors.mean, expected, 0.005 * expected);
  EXPECT_NEAR(errors.maximum, expected, 0.005 * expected);
}

TEST_F(SheetErrors, StatisticsInterpolateBetweenErrors) {
  // Vertex i of the first row is mapped to its first vertex: errors 0, 1, ..., 20 cells.
  Correspondence matches;
  for (int column = 0; column <= kColumns; ++column) matches.push_back({column, 0});
  const ErrorStatistics errors = template_errors(sheet_, sheet_, identity_truth(), matches);
  const double unit = kCell / sqrt_area_;
  EXPECT_EQ(errors.samples, 21);
  EXPECT_NEAR(errors.mean, 10 * unit, kRounding);
  EXPECT_NEAR(errors.median, 10 * unit, kRounding);
  EXPECT_NEAR(errors.p95, 19 * unit, kRounding);
  EXPECT_NEAR(errors.maximum, 20 * unit, kRounding);
}

TEST_F(SheetErrors, EveryMatchOfManyToManyCounts) {
  const Correspondence matches = {{0, 0}, {0, 4}, {5, 5}};
  const ErrorStatistics errors = template_errors(sheet_, sheet_, identity_truth(), matches);
  EXPECT_EQ(errors.samples, 3);
  EXPECT_NEAR(errors.mean, 4 * kCell / sqrt_area_ / 3, kRounding);
}

TEST_F(SheetErrors, TemplatePointsWithoutMatchAreLeftOut) {
  const GroundTruth points{{0, 1, 2}, {0, 1, 2}};
  const ErrorStatistics errors = template_errors(sheet_, sheet_, points, {{1, 3}, {9, 9}});
  EXPECT_EQ(errors.samples, 1);
  EXPECT_NEAR(errors.mean, 2 * kCell / sqrt_area_, kRounding);
}

TEST_F(SheetErrors, TemplatePointsThatAShapeLacksAreLeftOut) {
  const GroundTruth points{{0, kUnmatched, 2, 3}, {0, 1, kUnmatched, 3}};
  const Correspondence matches = {{0, 1}, {1, 1}, {2, 2}, {3, 3}};
  EXPECT_EQ(template_errors(sheet_, sheet_, points, matches).samples, 2);
  EXPECT_EQ(match_errors(sheet_, sheet_, points, matches).samples, 2);
  EXPECT_THAT(on_surfaces(sheet_, sheet_, points).source, ElementsAre(0, 3));
}

TEST_F(SheetErrors, MatchIsMeasuredAgainstFirstOfItsTemplatePoints) {
  const GroundTruth points{{7, 0, 0}, {7, 2, 10}};
  const Correspondence matches = {{0, 0}, {1, 1}, {7, 7}};
  const ErrorStatistics by_match = match_errors(sheet_, sheet_, points, matches);
  EXPECT_EQ(by_match.samples, 2);
  EXPECT_NEAR(by_match.maximum, 2 * kCell / sheet_.max_geodesic(), kRounding);
  const ErrorStatistics by_point = template_errors(sheet_, sheet_, points, matches);
  EXPECT_EQ(by_point.samples, 3);
  EXPECT_NEAR(by_point.mean, 12 * kCell / 3 / sqrt_area_, kRounding);
}

TEST_F(SheetErrors, NothingToMeasureIsAllZero) {
  const ErrorStatistics errors = template_errors(sheet_, sheet_, {{0}, {0}}, {{1, 1}});
  EXPECT_EQ(errors.samples, 0);
  EXPECT_EQ(errors.mean, 0);
}

TEST_F(SheetErrors, SamplesAreSpreadEvenly) {
  const Correspondence all = shift(1);
  const ErrorStatistics errors =
      template_errors(sheet_, sheet_, identity_truth(), all, {.max_samples = 7});
  EXPECT_EQ(errors.samples, 7);
  EXPECT_NEAR(errors.mean, kCell / sqrt_area_, kRounding);
  EXPECT_EQ(match_errors(sheet_, sheet_, identity_truth(), all, {.max_samples = 7}).samples, 7);
}

TEST_F(SheetErrors, BadInputThrows) {
  const int outside = sheet_.num_vertices();
  EXPECT_THROW(template_errors(sheet_, sheet_, {{0}, {outside}}, {{0, 0}}), InvalidInput);
  EXPECT_THROW(template_errors(sheet_, sheet_, {{0}, {0}}, {{0, outside}}), InvalidInput);
  EXPECT_THROW(template_errors(sheet_, sheet_, {{0}, {0}}, {{0, -1}}), InvalidInput);
  EXPECT_THROW(template_errors(sheet_, sheet_, {{0, 1}, {0}}, {{0, 0}}), InvalidInput);
  EXPECT_THROW(match_errors(sheet_, sheet_, {{0}, {0}}, {{outside, 0}}), InvalidInput);
  EXPECT_THROW(match_errors(sheet_, sheet_, {{0}, {0}}, {{0, 0}}, {.max_samples = 0}),
               InvalidInput);
  EXPECT_THROW(on_surfaces(sheet_, sheet_, {{0, 1}, {0}}), InvalidInput);
  EXPECT_THROW(on_surfaces(sheet_, sheet_, {{0}, {outside}}), InvalidInput);
  EXPECT_THROW(on_surfaces(sheet_, sheet_, {{-2}, {0}}), InvalidInput);
}

TEST_F(SheetErrors, StopIsHeeded) {
  std::stop_source stop;
  stop.request_stop();
  Context context;
  context.stop = stop.get_token();
  EXPECT_THROW(template_errors(sheet_, sheet_, identity_truth(), shift(3), {}, context), Cancelled);
}

TEST(TruthErrors, TurnOfCylinderHasLengthOfArc) {
  constexpr int kSegments = 24, kRings = 6, kTurn = 4;
  const Shape cylinder(test::open_cylinder(kSegments, kRings));
  Correspondence turned;
  for (int v = 0; v < cylinder.num_vertices(); ++v) {
    const int ring = v / kSegments, segment = v % kSegments;
    turned.push_back({v, ring * kSegments + (segment + kTurn) % kSegments});
  }
  std::vector<int> all(cylinder.num_vertices());
  std::iota(all.begin(), all.end(), 0);
  const ErrorStatistics errors = template_errors(cylinder, cylinder, {all, all}, turned);
  const double arc = kTurn * 2 * std::sin(M_PI / kSegments);
  EXPECT_NEAR(errors.mean, arc / std::sqrt(cylinder.area()), kRounding);
  EXPECT_NEAR(errors.maximum, arc / std::sqrt(cylinder.area()), kRounding);
}

TEST(TruthErrors, ScaleAndPositionOfTargetDoNotMatter) {
  test::Random random(1);
  const Mesh mesh = test::rough_sphere(3, 0.2, 5);
  const Shape shape(mesh), other(test::scaled(test::moved(mesh, random), 7));
  Correspondence input;
  std::vector<int> all(mesh.num_vertices());
  std::iota(all.begin(), all.end(), 0);
  for (int v : all) input.push_back({v, random.index(mesh.num_vertices())});
  const auto errors_on = [&](const Shape& target) {
    return template_errors(shape, target, {all, all}, input);
  };
  EXPECT_NEAR(errors_on(shape).mean, errors_on(other).mean, 1e-4);
  EXPECT_NEAR(errors_on(shape).maximum, errors_on(other).maximum, 1e-4);
}

TEST(TruthErrors, VerticesOffTheSurfaceAreLeftOut) {
  const Mesh mesh = test::sphere_with_unreferenced_vertices();
  const Shape shape(mesh);
  const int last = mesh.num_vertices() - 1;
  const GroundTruth given{{0, 6, 8, 5}, {6, 7, 1, 5}};
  const GroundTruth truth = on_surfaces(shape, shape, given);
  EXPECT_THAT(truth.source, ElementsAre(6, 5));
  EXPECT_THAT(truth.target, ElementsAre(7, 5));
  const Correspondence matches{{0, 5}, {5, last}, {6, 7}};
  EXPECT_EQ(template_errors(shape, shape, given, matches).samples, 1);
  EXPECT_EQ(template_errors(shape, shape, given, matches).maximum, 0);
  EXPECT_EQ(match_errors(shape, shape, given, matches).samples, 1);
}

TEST(TruthErrors, CopiesAtASeamAreOneVertex) {
  const Mesh sphere = test::icosphere(2);
  const Shape shape(test::split_charts(sphere, test::octants(sphere)));
  ASSERT_EQ(shape.num_surface_vertices(), sphere.num_vertices());
  std::vector<int> numbers(shape.num_vertices());
  std::iota(numbers.begin(), numbers.end(), 0);
  Correspondence all;
  for (int v : numbers) all.push_back({v, v});
  const ErrorStatistics errors = match_errors(shape, shape, {numbers, numbers}, all);
  EXPECT_EQ(errors.samples, sphere.num_vertices());
  EXPECT_EQ(errors.maximum, 0);
  // The truth is known at one copy, the match at another.
  const int v = static_cast<int>(shape.num_vertices()) - 1;
  ASSERT_GT(shape.copies(v).size(), 1);
  const int copy = shape.copies(v).front();
  EXPECT_EQ(template_errors(shape, shape, {{v}, {v}}, {{copy, copy}}).samples, 1);
  EXPECT_EQ(template_errors(shape, shape, {{v}, {v}}, {{copy, copy}}).maximum, 0);
  const std::vector<double> by_vertex =
      vertex_errors(shape, shape, {{v}, {v}}, Correspondence{{copy, copy}});
  for (int w : shape.copies(v)) EXPECT_EQ(by_vertex[w], 0);
}

TEST(TargetCoverage, IsShareOfVerticesAndArea) {
  const Shape sheet(test::sheet(2, 1));
  const auto hit = [&](const Correspondence& matches) {
    return target_coverage(sheet, sheet, matches);
  };
  EXPECT_EQ(hit({}).vertices, 0);
  EXPECT_NEAR(hit({{0, 0}, {1, 0}, {1, 1}, {2, 2}, {3, 0}}).vertices, 0.5, 1e-12);
  // The middle vertex of the first row has one or two of the four triangles on either side, the
  // rest of the row the remaining ones: with its counterpart they share the sheet.
  const double first_row = hit({{0, 0}, {1, 1}, {2, 2}}).area;
  const double second_row = hit({{0, 3}, {1, 4}, {2, 5}}).area;
  EXPECT_NEAR(first_row, 0.5, 1e-12);
  EXPECT_NEAR(first_row + second_row, 1, 1e-12);
}

}  // namespace
}  // namespace isomatch
