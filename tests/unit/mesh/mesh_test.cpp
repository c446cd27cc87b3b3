// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "isomatch/error.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

constexpr double kPi = std::numbers::pi;
/// Sums of a few hundred terms of order 1.
constexpr double kRounding = 1e-12;

template <class Validate>
void expect_refused(const Validate& check, const Mesh& mesh, const std::string& reason) {
  try {
    check(mesh);
    FAIL() << "accepted: " << reason;
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr(reason));
  }
}

void expect_invalid(const Mesh& mesh, const std::string& reason) {
  expect_refused(validate, mesh, reason);
}

TEST(Mesh, ValidationNamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Mesh sheet = test::sheet(2, 2);
  EXPECT_NO_THROW(validate(sheet));
  expect_invalid({}, "no vertices");
  expect_invalid({sheet.vertices, {}}, "no faces");
  for (const auto& [value, vertex] : {std::pair(nan, 3), {infinity, 0}, {-infinity, 8}}) {
    Mesh mesh = sheet;
    mesh.vertices[vertex].y() = value;
    EXPECT_NO_THROW(validate(mesh));
    expect_refused(validate_finite, mesh, "vertex " + std::to_string(vertex) + " ");
  }
  for (int vertex : {-1, 9, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    Mesh mesh = sheet;
    mesh.faces[5][1] = vertex;
    expect_invalid(mesh, "face 5 names vertex " + std::to_string(vertex));
  }
}

TEST(Mesh, AreasOfFlatShapesAreExact) {
  EXPECT_NEAR(surface_area(test::sheet(7, 3, 2.5, 0.5)), 1.25, kRounding);
  EXPECT_NEAR(surface_area(test::box(5, Point(1, 2, 3))), 22, kRounding);
  const double side = 2 * 12 * std::sin(kPi / 12) * 2;
  EXPECT_NEAR(surface_area(test::open_cylinder(12, 4)), side, kRounding);
  EXPECT_NEAR(surface_area(test::closed_cylinder(12, 4)), side + 12 * std::sin(kPi / 6), kRounding);
}

TEST(Mesh, AreasOfCurvedShapesConvergeQuadratically) {
  // Chords and facets of size h fall short of the smooth area by a relative O(h^2), here 1.2
  // permille for the sphere (h = 1/13) and 4 permille for the others (h = 2 pi / 64).
  EXPECT_NEAR(surface_area(test::icosphere(4)) / (4 * kPi), 1, 0.0012);
  EXPECT_NEAR(surface_area(test::uv_sphere(64, 32)) / (4 * kPi), 1, 0.004);
  EXPECT_NEAR(surface_area(test::torus(64, 64)) / (8 * kPi * kPi), 1, 0.004);
  EXPECT_NEAR(surface_area(test::rolled_sheet(64, 4, 3, 2, 2 * kPi)) / 6, 1, 0.004);
}

TEST(Mesh, VertexAreasSumToTheSurfaceArea) {
  const Mesh mesh = test::rough_sphere(2, 0.3, 7);
  const std::vector<double> areas = vertex_areas(mesh);
  ASSERT_EQ(areas.size(), mesh.vertices.size());
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), surface_area(mesh), kRounding);
}

TEST(Mesh, VertexAreaIsAThirdOfTheFacesAround) {
  // Of the eight triangles of a 2 x 2 sheet, area 1/8 each, the middle vertex touches six.
  EXPECT_DOUBLE_EQ(vertex_areas(test::sheet(2, 2))[4], 6.0 / 8 / 3);
  EXPECT_DOUBLE_EQ(vertex_areas(test::sheet(2, 2))[0], 2.0 / 8 / 3);
}

TEST(Mesh, WeightedVertexNormalsAreTwiceTheFacesAround) {
  const Mesh triangle{{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {5, 5, 5}}, {{0, 1, 2}}};
  const std::vector<Point> normals = weighted_vertex_normals(triangle);
  for (int v = 0; v < 3; ++v) EXPECT_EQ(normals[v], Point(0, 0, 6));
  EXPECT_EQ(normals[3], Point(0, 0, 0));
}

}  // namespace
}  // namespace isomatch
