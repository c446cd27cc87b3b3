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

/// A flat sheet under its own numbers: surfaces renumber, so matches are given in input vertices.
class SheetErrors : public testing::Test {
 protected:
  Correspondence on_surface(const Correspondence& input) const {
    return surface_matches(sheet_.surface, sheet_.surface, input);
  }

  GroundTruth identity_truth() const {
    std::vector<int> all(sheet_.num_vertices());
    std::iota(all.begin(), all.end(), 0);
    return {all, all};
  }

  GroundTruth truth(const std::vector<int>& source, const std::vector<int>& target) const {
    return surface_truth(sheet_.surface, sheet_.surface, source, target);
  }

  /// Every vertex to the one `columns` to the right of it, where there is one.
  Correspondence shift(int columns) const {
    Correspondence matches;
    for (int row = 0; row <= kRows; ++row) {
      for (int column = 0; column + columns <= kColumns; ++column)
        matches.push_back({sheet_vertex(column, row), sheet_vertex(column + columns, row)});
    }
    return on_surface(matches);
  }

  const Shape sheet_ = prepare_shape(test::sheet(kColumns, kRows, kWidth, kHeight));
  const double sqrt_area_ = std::sqrt(kWidth * kHeight);
};

TEST_F(SheetErrors, IdentityHasNone) {
  const ErrorStatistics errors = template_errors(sheet_, identity_truth(), shift(0));
  EXPECT_EQ(errors.samples, sheet_.num_vertices());
  EXPECT_EQ(errors.maximum, 0);
  EXPECT_EQ(match_errors(sheet_, identity_truth(), shift(0)).maximum, 0);
}

TEST_F(SheetErrors, ShiftHasItsLengthEverywhere) {
  const ErrorStatistics errors = template_errors(sheet_, identity_truth(), shift(3));
  EXPECT_EQ(errors.samples, (kColumns - 2) * (kRows + 1));
  for (double error : {errors.mean, errors.median, errors.p95, errors.maximum})
    EXPECT_NEAR(error, 3 * kCell / sqrt_area_, kRounding);
}

TEST_F(SheetErrors, MatchErrorsAreRelativeToDiagonal) {
  const ErrorStatistics errors = match_errors(sheet_, identity_truth(), shift(3));
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
  const ErrorStatistics errors = template_errors(sheet_, identity_truth(), on_surface(matches));
  const double unit = kCell / sqrt_area_;
  EXPECT_EQ(errors.samples, 21);
  EXPECT_NEAR(errors.mean, 10 * unit, kRounding);
  EXPECT_NEAR(errors.median, 10 * unit, kRounding);
  EXPECT_NEAR(errors.p95, 19 * unit, kRounding);
  EXPECT_NEAR(errors.maximum, 20 * unit, kRounding);
}

TEST_F(SheetErrors, EveryMatchOfManyToManyCounts) {
  const Correspondence matches = on_surface({{0, 0}, {0, 4}, {5, 5}});
  const ErrorStatistics errors = template_errors(sheet_, identity_truth(), matches);
  EXPECT_EQ(errors.samples, 3);
  EXPECT_NEAR(errors.mean, 4 * kCell / sqrt_area_ / 3, kRounding);
}

TEST_F(SheetErrors, TemplatePointsWithoutMatchAreLeftOut) {
  const GroundTruth points = truth({0, 1, 2}, {0, 1, 2});
  const ErrorStatistics errors = template_errors(sheet_, points, on_surface({{1, 3}, {9, 9}}));
  EXPECT_EQ(errors.samples, 1);
  EXPECT_NEAR(errors.mean, 2 * kCell / sqrt_area_, kRounding);
}

TEST_F(SheetErrors, MatchIsMeasuredAgainstFirstOfItsTemplatePoints) {
  const GroundTruth points = truth({7, 0, 0}, {7, 2, 10});
  const Correspondence matches = on_surface({{0, 0}, {1, 1}, {7, 7}});
  const ErrorStatistics by_match = match_errors(sheet_, points, matches);
  EXPECT_EQ(by_match.samples, 2);
  EXPECT_NEAR(by_match.maximum, 2 * kCell / sheet_.max_geodesic, kRounding);
  const ErrorStatistics by_point = template_errors(sheet_, points, matches);
  EXPECT_EQ(by_point.samples, 3);
  EXPECT_NEAR(by_point.mean, 12 * kCell / 3 / sqrt_area_, kRounding);
}

TEST_F(SheetErrors, NothingToMeasureIsAllZero) {
  const ErrorStatistics errors = template_errors(sheet_, truth({0}, {0}), on_surface({{1, 1}}));
  EXPECT_EQ(errors.samples, 0);
  EXPECT_EQ(errors.mean, 0);
}

TEST_F(SheetErrors, SamplesAreSpreadEvenly) {
  const Correspondence all = shift(1);
  const ErrorStatistics errors = template_errors(sheet_, identity_truth(), all, {.max_samples = 7});
  EXPECT_EQ(errors.samples, 7);
  EXPECT_NEAR(errors.mean, kCell / sqrt_area_, kRounding);
  EXPECT_EQ(match_errors(sheet_, identity_truth(), all, {.max_samples = 7}).samples, 7);
}

TEST_F(SheetErrors, BadInputThrows) {
  const int outside = sheet_.num_vertices();
  EXPECT_THROW(template_errors(sheet_, {{0}, {outside}}, {{0, 0}}), InvalidInput);
  EXPECT_THROW(template_errors(sheet_, {{0}, {0}}, {{0, outside}}), InvalidInput);
  EXPECT_THROW(template_errors(sheet_, {{0}, {0}}, {{0, -1}}), InvalidInput);
  EXPECT_THROW(template_errors(sheet_, {{0, 1}, {0}}, {{0, 0}}), InvalidInput);
  EXPECT_THROW(match_errors(sheet_, {{0}, {0}}, {{1, 1}, {0, 0}}), InvalidInput);
  EXPECT_THROW(match_errors(sheet_, {{0}, {0}}, {{0, 0}}, {.max_samples = 0}), InvalidInput);
  EXPECT_THROW(truth({0, 1}, {0}), InvalidInput);
  EXPECT_THROW(truth({0}, {outside}), InvalidInput);
  EXPECT_THROW(on_surface({{-1, 0}}), InvalidInput);
}

TEST_F(SheetErrors, StopIsHeeded) {
  std::stop_source stop;
  stop.request_stop();
  Context context;
  context.stop = stop.get_token();
  EXPECT_THROW(template_errors(sheet_, identity_truth(), shift(3), {}, context), Cancelled);
}

TEST(TruthErrors, TurnOfCylinderHasLengthOfArc) {
  constexpr int kSegments = 24, kRings = 6, kTurn = 4;
  const Shape cylinder = prepare_shape(test::open_cylinder(kSegments, kRings));
  Correspondence turned;
  for (int v = 0; v < cylinder.num_vertices(); ++v) {
    const int ring = v / kSegments, segment = v % kSegments;
    turned.push_back({v, ring * kSegments + (segment + kTurn) % kSegments});
  }
  const auto matches = surface_matches(cylinder.surface, cylinder.surface, turned);
  std::vector<int> all(cylinder.num_vertices());
  std::iota(all.begin(), all.end(), 0);
  const ErrorStatistics errors = template_errors(cylinder, {all, all}, matches);
  const double arc = kTurn * 2 * std::sin(M_PI / kSegments) / cylinder.unit;
  EXPECT_NEAR(errors.mean, arc / std::sqrt(cylinder.surface.area), kRounding);
  EXPECT_NEAR(errors.maximum, arc / std::sqrt(cylinder.surface.area), kRounding);
}

TEST(TruthErrors, ScaleAndPositionOfTargetDoNotMatter) {
  test::Random random(1);
  const Mesh mesh = test::rough_sphere(3, 0.2, 5);
  const Shape shape = prepare_shape(mesh);
  const Shape other = prepare_shape(test::scaled(test::moved(mesh, random), 7));
  Correspondence input;
  std::vector<int> all(mesh.num_vertices());
  std::iota(all.begin(), all.end(), 0);
  for (int v : all) input.push_back({v, random.index(mesh.num_vertices())});
  const auto errors_on = [&](const Shape& target) {
    return template_errors(target, surface_truth(shape.surface, target.surface, all, all),
                           surface_matches(shape.surface, target.surface, input));
  };
  EXPECT_NEAR(errors_on(shape).mean, errors_on(other).mean, 1e-4);
  EXPECT_NEAR(errors_on(shape).maximum, errors_on(other).maximum, 1e-4);
}

TEST(SurfaceNumbers, VerticesOffTheSurfaceAreLeftOut) {
  const Mesh mesh = test::sphere_with_unreferenced_vertices();
  const Surface surface = extract_surface(mesh);
  const int last = mesh.num_vertices() - 1;
  EXPECT_THAT(surface_matches(surface, surface, {{0, 5}, {5, last}, {6, 7}}),
              ElementsAre(Match{surface.surface_vertex[6], surface.surface_vertex[7]}));
  const GroundTruth truth =
      surface_truth(surface, surface, std::vector{0, 6, 8}, std::vector{6, 7, 1});
  EXPECT_THAT(truth.source, ElementsAre(surface.surface_vertex[6]));
  EXPECT_THAT(truth.target, ElementsAre(surface.surface_vertex[7]));
}

TEST(SurfaceNumbers, JoinedVerticesGiveOneMatch) {
  const Mesh sphere = test::icosphere(2);
  const Surface surface = extract_surface(test::split_charts(sphere, test::octants(sphere)));
  ASSERT_EQ(surface.num_vertices(), sphere.num_vertices());
  Correspondence all;
  for (int v = 0; v < static_cast<int>(surface.surface_vertex.size()); ++v) all.push_back({v, v});
  EXPECT_EQ(surface_matches(surface, surface, all).size(), sphere.vertices.size());
}

TEST(TargetCoverage, IsShareOfVerticesAndArea) {
  const Shape sheet = prepare_shape(test::sheet(2, 1));
  const auto hit = [&](const Correspondence& matches) {
    return target_coverage(sheet, surface_matches(sheet.surface, sheet.surface, matches));
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
