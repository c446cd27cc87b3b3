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
    for (const Point& p : sheet_.surface.mesh.vertices)
      map.push_back(point_at(p + kCell * Point(dx, dy, 0)));
    return map;
  }

  ErrorStatistics errors(const SurfaceMap& map, const TruthOptions& options = {},
                         const Context& context = {}) const {
    return point_errors(sheet_, identity(sheet_), map, options, context);
  }

  SurfacePoint point_at(const Point& x) const {
    const Mesh& mesh = sheet_.surface.mesh;
    for (int f = 0; f < mesh.num_faces(); ++f) {
      const std::array<double, 3> weights = weights_in(mesh.faces[f], x);
      if (*std::ranges::min_element(weights) > -1e-9) return {f, weights};
    }
    return {};
  }

  std::array<double, 3> weights_in(const Face& face, const Point& x) const {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = sheet_.surface.mesh.vertices[face[k]];
    corners.row(2).setOnes();
    const Eigen::Vector3d weights = corners.inverse() * Point(x[0], x[1], 1);
    return {weights[0], weights[1], weights[2]};
  }

  const Shape sheet_ = prepare_shape(test::sheet(kColumns, kRows, kColumns* kCell, kRows* kCell));
  const double unit_ = kCell / std::sqrt(sheet_.surface.area);
};

TEST_F(SheetPoints, IdentityHasNoError) {
  const ErrorStatistics none = errors(points_at(sheet_.surface.mesh, identity(sheet_).source));
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
  const ErrorStatistics points = errors(points_at(sheet_.surface.mesh, map));
  const ErrorStatistics vertices =
      template_errors(sheet_, identity(sheet_), to_correspondence(map));
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

TEST_F(SheetPoints, TheListHasAnErrorForEachTemplatePoint) {
  SurfaceMap map = shifted(0, 0.5);
  map[7] = {};
  const GroundTruth truth{{3, 7, 3, 0}, {3, 7, 4, 0}};
  const std::vector<double> list = point_error_list(sheet_, truth, map);
  ASSERT_EQ(list.size(), 4U);
  EXPECT_NEAR(list[0], 0.5 * unit_, kRounding);
  EXPECT_TRUE(std::isnan(list[1]));
  // Vertices 3 and 4 are neighbours on the sheet, so the error is a straight line.
  const Mesh& mesh = sheet_.surface.mesh;
  EXPECT_NEAR(list[2], (position(mesh, map[3]) - mesh.vertices[4]).norm() / kCell * unit_,
              0.01 * unit_);
  EXPECT_NEAR(list[3], 0.5 * unit_, kRounding);
  EXPECT_THROW(point_error_list(sheet_, {{0, 0}, {0}}, map), InvalidInput);
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
  const SurfacePoint point{0, {1, 0, 0}};
  const int faces = sheet_.surface.mesh.num_faces(), vertices = sheet_.num_vertices();
  EXPECT_THROW(point_errors(sheet_, {{0}, {0}}, {{faces, {1, 0, 0}}}), InvalidInput);
  EXPECT_THROW(point_errors(sheet_, {{0}, {0}}, {{-2, {1, 0, 0}}}), InvalidInput);
  EXPECT_THROW(point_errors(sheet_, {{1}, {0}}, {point}), InvalidInput);
  EXPECT_THROW(point_errors(sheet_, {{0}, {vertices}}, {point}), InvalidInput);
  EXPECT_THROW(point_errors(sheet_, {{0, 0}, {0}}, {point}), InvalidInput);
  EXPECT_THROW(point_errors(sheet_, {{0}, {0}}, {point}, {.max_samples = 0}), InvalidInput);
}

TEST(PointErrors, AreGreatCirclesOnASphere) {
  const Shape sphere = prepare_shape(test::icosphere(4));
  const Mesh& mesh = sphere.surface.mesh;
  test::Random random(5);
  for (int i = 0; i < 50; ++i) {
    const SurfacePoint point{random.index(mesh.num_faces()), {0.5, 0.3, 0.2}};
    const int truth = random.index(mesh.num_vertices());
    const double angle =
        std::acos(mesh.vertices[truth].normalized().dot(position(mesh, point).normalized()));
    const double error = point_errors(sphere, {{0}, {truth}}, {point}).mean;
    // The visibility graph's .2 % on average, .6 % at worst on this mesh.
    EXPECT_NEAR(error * sphere.unit * std::sqrt(sphere.surface.area), angle, 0.01 * angle);
  }
}

}  // namespace
}  // namespace isomatch
