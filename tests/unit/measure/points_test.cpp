// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "support/context.h"
#include "support/random.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

/// Distances are sums of floats: relative error of some 1e-6.
constexpr double kRounding = 1e-5;

constexpr int kColumns = 20, kRows = 10;
constexpr double kCell = 0.1;

GroundTruth identity(const Shape& shape) {
  std::vector<int> all(shape.num_vertices());
  std::iota(all.begin(), all.end(), 0);
  return {all, all};
}

/// A point for each vertex of the mesh: vertex v, of the first face that has it.
SurfaceMap points_at(const Mesh& mesh, const std::vector<int>& vertices) {
  SurfaceMap map;
  for (int v : vertices) {
    SurfacePoint point;
    for (int f = 0; point.face < 0; ++f) {
      for (int k = 0; k < 3; ++k)
        if (mesh.faces[f][k] == v)
          point = {f, {k == 0 ? 1.0 : 0, k == 1 ? 1.0 : 0, k == 2 ? 1.0 : 0}};
    }
    map.push_back(point);
  }
  return map;
}

class SheetPoints : public testing::Test {
 protected:
  /// Every vertex to the point (dx, dy) cells from it, where that is on the sheet.
  SurfaceMap shifted(double dx, double dy) const {
    SurfaceMap map;
    for (const Point& p : sheet_.mesh().vertices)
      map.push_back(point_at(p + kCell * Point(dx, dy, 0)));
    return map;
  }

  ErrorStatistics errors(const SurfaceMap& map, const TruthOptions& options = {},
                         const Context& context = {}) const {
    return point_errors(sheet_, sheet_, identity(sheet_), map, options, context);
  }

  SurfacePoint point_at(const Point& x) const {
    const Mesh& mesh = sheet_.mesh();
    for (int f = 0; f < mesh.num_faces(); ++f) {
      const std::array<double, 3> weights = weights_in(mesh.faces[f], x);
      if (*std::ranges::min_element(weights) > -1e-9) return {f, weights};
    }
    return {};
  }

  std::array<double, 3> weights_in(const Face& face, const Point& x) const {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = sheet_.mesh().vertices[face[k]];
    corners.row(2).setOnes();
    const Eigen::Vector3d weights = corners.inverse() * Point(x[0], x[1], 1);
    return {weights[0], weights[1], weights[2]};
  }

  const Shape sheet_{test::sheet(kColumns, kRows, kColumns* kCell, kRows* kCell)};
  const double unit_ = kCell / std::sqrt(sheet_.area());
};

TEST_F(SheetPoints, IdentityHasNoError) {
  const ErrorStatistics none = errors(points_at(sheet_.mesh(), identity(sheet_).source));
  EXPECT_EQ(none.samples, sheet_.num_vertices());
  EXPECT_EQ(none.maximum, 0);
}

TEST_F(SheetPoints, ShiftHasItsLengthBelowAnEdge) {
  for (const auto& [dx, dy] : {std::pair{0.25, 0.0}, {0.0, 0.5}, {0.4, 0.1}, {0.2, 0.7}}) {
    const ErrorStatistics shift = errors(shifted(dx, dy));
    EXPECT_EQ(shift.samples, (kColumns + (dx == 0)) * (kRows + (dy == 0)));
    EXPECT_NEAR(shift.mean, std::hypot(dx, dy) * unit_, kRounding);
    EXPECT_NEAR(shift.maximum, std::hypot(dx, dy) * unit_, kRounding);
  }
}

TEST_F(SheetPoints, ShiftHasItsLengthAlongTheGrid) {
  const ErrorStatistics shift = errors(shifted(2.5, 0));
  EXPECT_NEAR(shift.mean, 2.5 * unit_, kRounding);
  EXPECT_NEAR(shift.maximum, 2.5 * unit_, kRounding);
}

TEST_F(SheetPoints, PointsAtVerticesHaveTheErrorsOfVertices) {
  test::Random random(2);
  const std::vector<int> map = random.permutation(sheet_.num_vertices());
  const ErrorStatistics points = errors(points_at(sheet_.mesh(), map));
  const ErrorStatistics vertices =
      template_errors(sheet_, sheet_, identity(sheet_), to_correspondence(map));
  EXPECT_DOUBLE_EQ(points.mean, vertices.mean);
  EXPECT_DOUBLE_EQ(points.p95, vertices.p95);
  EXPECT_DOUBLE_EQ(points.maximum, vertices.maximum);
}

TEST_F(SheetPoints, VerticesWithoutPointAreLeftOut) {
  SurfaceMap map = shifted(0.25, 0);
  std::fill(map.begin() + 5, map.end(), SurfacePoint{});
  EXPECT_LE(errors(map).samples, 5);
  EXPECT_EQ(errors(SurfaceMap(map.size())).samples, 0);
}

TEST_F(SheetPoints, VertexErrorsAreMeansOverTheTemplatePointsThere) {
  SurfaceMap map = shifted(0, 0.5);
  map[7] = {};
  const GroundTruth truth{{3, 7, 3, 0}, {3, 7, 4, 0}};
  const std::vector<double> errors = vertex_errors(sheet_, sheet_, truth, map);
  ASSERT_EQ(std::ssize(errors), sheet_.num_vertices());
  // Vertices 3 and 4 are neighbours on the sheet, so the other error is a straight line.
  const Mesh& mesh = sheet_.mesh();
  const double other = (position(mesh, map[3]) - mesh.vertices[4]).norm() / kCell * unit_;
  EXPECT_NEAR(errors[3], (0.5 * unit_ + other) / 2, 0.005 * unit_);
  EXPECT_NEAR(errors[0], 0.5 * unit_, kRounding);
  EXPECT_EQ(std::ranges::count_if(errors, [](double e) { return std::isnan(e); }),
            sheet_.num_vertices() - 2);
  EXPECT_THROW(vertex_errors(sheet_, sheet_, {{0, 0}, {0}}, map), InvalidInput);
  map.pop_back();
  EXPECT_THROW(vertex_errors(sheet_, sheet_, truth, map), InvalidInput);
}

TEST_F(SheetPoints, VertexErrorsOfMatchesAreMeansOverTheseAsWell) {
  const GroundTruth truth{{3, 7, 3, 5}, {3, 7, 4, 5}};
  const Correspondence matches{{3, 3}, {3, 6}, {5, 7}, {9, 9}};
  const std::vector<double> errors = vertex_errors(sheet_, sheet_, truth, matches);
  // From 3 to 3 and 6, from 4 to 3 and 6, which are 0, 3, 1 and 2 cells.
  EXPECT_NEAR(errors[3], 1.5 * unit_, kRounding);
  EXPECT_NEAR(errors[5], 2 * unit_, kRounding);
  EXPECT_EQ(std::ranges::count_if(errors, [](double e) { return std::isnan(e); }),
            sheet_.num_vertices() - 2);
}

TEST_F(SheetPoints, SamplesAndThreadsAreHeeded) {
  const SurfaceMap map = shifted(1.3, 0.6);
  EXPECT_EQ(errors(map, {.max_samples = 7}).samples, 7);
  EXPECT_EQ(errors(map, {}, test::with_threads(1)).mean,
            errors(map, {}, test::with_threads(3)).mean);
  std::stop_source stop;
  stop.request_stop();
  Context context;
  context.stop = stop.get_token();
  EXPECT_THROW(errors(map, {}, context), Cancelled);
}

TEST_F(SheetPoints, BadInputThrows) {
  const int faces = sheet_.mesh().num_faces(), vertices = sheet_.num_vertices();
  const auto all_at = [&](int face) {
    return SurfaceMap(static_cast<std::size_t>(vertices), {face, {1, 0, 0}});
  };
  const auto expect_rejected = [&](const GroundTruth& truth, const SurfaceMap& map,
                                   const TruthOptions& options = {}) {
    EXPECT_THROW(point_errors(sheet_, sheet_, truth, map, options), InvalidInput);
  };
  expect_rejected({{0}, {0}}, all_at(faces));
  expect_rejected({{0}, {0}}, all_at(-2));
  expect_rejected({{0}, {0}}, {{0, {1, 0, 0}}});
  expect_rejected({{vertices}, {0}}, all_at(0));
  expect_rejected({{-2}, {0}}, all_at(0));
  expect_rejected({{0}, {vertices}}, all_at(0));
  expect_rejected({{0, 0}, {0}}, all_at(0));
  expect_rejected({{0}, {0}}, all_at(0), {.max_samples = 0});
}

TEST(PointErrors, AreGreatCirclesOnASphere) {
  const Shape sphere(test::icosphere(4));
  const Mesh& mesh = sphere.mesh();
  test::Random random(5);
  for (int i = 0; i < 50; ++i) {
    const SurfacePoint point{random.index(mesh.num_faces()), {0.5, 0.3, 0.2}};
    const int truth = random.index(mesh.num_vertices());
    const double angle =
        std::acos(mesh.vertices[truth].normalized().dot(position(mesh, point).normalized()));
    SurfaceMap map(mesh.vertices.size());
    map[0] = point;
    const double error = point_errors(sphere, sphere, {{0}, {truth}}, map).mean;
    // The visibility graph's .2 % on average, .6 % at worst on this mesh.
    EXPECT_NEAR(error * std::sqrt(sphere.area()), angle, 0.01 * angle);
  }
}

}  // namespace
}  // namespace isomatch
