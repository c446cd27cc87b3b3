// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/measure/registered_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "isomatch/error.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

/// Of sums of areas.
constexpr double kSumRounding = 1e-12;

/// A flat sheet of squares, whose corner at the origin and the one opposite to it belong to two
/// triangles, the other two to one each.
class RegisteredSheet : public testing::Test {
 protected:
  static constexpr int kColumns = 20, kRows = 10, kFaces = 2 * kColumns * kRows;
  static constexpr double kCell = 0.1;

  /// The sheet with its lone corner moved towards the middle of the edge across its triangle by
  /// this part of the way; 2 turns the triangle over.
  RegisteredSurface moved(double part) const {
    std::vector<Point> registered = sheet_.vertices;
    registered[kColumns] += part * Point(-kCell / 2, kCell / 2, 0);
    return measure_registered(sheet_, registered, sheet_);
  }

  const Mesh sheet_ = test::sheet(kColumns, kRows, kColumns* kCell, kRows* kCell);
};

TEST_F(RegisteredSheet, IsSoundWhereNothingMoves) {
  const RegisteredSurface surface = moved(0);
  EXPECT_EQ(surface.folded, 0);
  EXPECT_EQ(surface.squeezed, 0);
  EXPECT_NEAR(surface.reach, 1, kSumRounding);
}

TEST_F(RegisteredSheet, IsFoldedOnBothSidesOfTheEdgeThatATriangleIsTurnedOverAt) {
  const RegisteredSurface surface = moved(2);
  EXPECT_NEAR(surface.folded, 2.0 / kFaces, kSumRounding);
  EXPECT_EQ(surface.squeezed, 0);
}

TEST_F(RegisteredSheet, CountsTheTrianglesWithLessThanATenthOfTheirArea) {
  EXPECT_EQ(moved(0.89).squeezed, 0);
  EXPECT_NEAR(moved(0.91).squeezed, 1.0 / kFaces, kSumRounding);
  EXPECT_EQ(moved(0.91).folded, 0);
}

TEST_F(RegisteredSheet, IsNotSqueezedWhenTheWholeIsSmaller) {
  Mesh small = sheet_;
  for (Point& p : small.vertices) p *= 0.1;
  const RegisteredSurface surface = measure_registered(sheet_, small.vertices, small);
  EXPECT_EQ(surface.squeezed, 0);
  EXPECT_NEAR(surface.reach, 1, kSumRounding);
}

TEST_F(RegisteredSheet, MayBeTurnedAtRandom) {
  Mesh turned = sheet_;
  for (std::size_t f = 0; f < turned.faces.size(); f += 3)
    std::swap(turned.faces[f][0], turned.faces[f][1]);
  EXPECT_EQ(measure_registered(turned, turned.vertices, sheet_).folded, 0);
}

TEST_F(RegisteredSheet, ThatHasCollapsedIsSqueezedAll) {
  const std::vector<Point> nowhere(sheet_.vertices.size(), Point::Zero());
  EXPECT_EQ(measure_registered(sheet_, nowhere, sheet_).squeezed, 1);
}

TEST_F(RegisteredSheet, ReachesANeedleInNoTime) {
  Mesh needle = sheet_;
  const int first = needle.num_vertices();
  needle.vertices.insert(needle.vertices.end(), {{0, 0, 0}, {1e6, 0, 0}, {0, 1e-9, 0}});
  needle.faces.push_back({first, first + 1, first + 2});
  EXPECT_GT(measure_registered(sheet_, sheet_.vertices, needle).reach, 0.9);
}

TEST_F(RegisteredSheet, NeedsAPositionForEachVertex) {
  const std::vector<Point> few(sheet_.vertices.begin() + 1, sheet_.vertices.end());
  EXPECT_THROW(measure_registered(sheet_, few, sheet_), InvalidInput);
}

TEST(RegisteredSphere, ReachesItself) {
  const Mesh sphere = test::icosphere(3);
  const RegisteredSurface surface = measure_registered(sphere, sphere.vertices, sphere);
  EXPECT_EQ(surface.folded, 0);
  EXPECT_EQ(surface.squeezed, 0);
  EXPECT_NEAR(surface.reach, 1, kSumRounding);
}

/// Beyond the rim it reaches a strip as wide as the distance, .01 sqrt(4 pi), of 2 pi of the area.
TEST(RegisteredSphere, ReachesHalfOfItWhereItIsHalf) {
  const Mesh sphere = test::uv_sphere(80, 40);
  Mesh half{sphere.vertices, {}};
  for (const Face& face : sphere.faces)
    if (sphere.vertices[face[0]].z() + sphere.vertices[face[1]].z() + sphere.vertices[face[2]].z() >
        0)
      half.faces.push_back(face);
  const RegisteredSurface surface = measure_registered(half, half.vertices, sphere);
  const double strip = 0.01 * std::sqrt(4 * std::numbers::pi);
  // Samples are .035 apart, in rows of which one more or less is .009 of the area.
  EXPECT_NEAR(surface.reach, (1 + std::sin(strip)) / 2, 0.009);
}

}  // namespace
}  // namespace isomatch
