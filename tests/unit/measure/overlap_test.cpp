// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/measure/overlap.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "support/context.h"
#include "support/maps.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

/// Distances are sums of floats: relative error of some 1e-6.
constexpr double kRounding = 1e-5;
/// Of sums of areas.
constexpr double kSumRounding = 1e-12;

constexpr int kColumns = 20, kRows = 10;
constexpr double kCell = 0.1;

VertexMap identity(const Shape& shape) {
  VertexMap map(shape.num_vertices());
  std::iota(map.begin(), map.end(), 0);
  return map;
}

/// A flat sheet and itself.
class SheetOverlap : public testing::Test {
 protected:
  /// The identity on the vertices whose column is in [first, last].
  VertexMap columns(int first, int last) const {
    VertexMap map = identity(sheet_);
    for (int& v : map)
      if (const int column = v % (kColumns + 1); column < first || column > last) v = kUnmatched;
    return map;
  }

  /// The same as points, `dx` cells to the right.
  SurfaceMap shifted_columns(int first, int last, double dx) const {
    SurfaceMap points;
    for (const int v : columns(first, last))
      points.push_back(v == kUnmatched
                           ? SurfacePoint{}
                           : point_at(sheet_.mesh().vertices[v] + Point(dx * kCell, 0, 0)));
    return points;
  }

  SurfacePoint point_at(const Point& x) const {
    const Mesh& mesh = sheet_.mesh();
    for (int f = 0; f < mesh.num_faces(); ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      const double area = cross(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
      const double first = cross(x, mesh.vertices[b], mesh.vertices[c]) / area;
      const double second = cross(mesh.vertices[a], x, mesh.vertices[c]) / area;
      if (std::min({first, second, 1 - first - second}) < -1e-9) continue;
      return {f, {first, second, 1 - first - second}};
    }
    return {};
  }

  static double cross(const Point& a, const Point& b, const Point& c) {
    return (b - a).cross(c - a).z();
  }

  OverlapQuality quality(const VertexMap& truth, const VertexMap& map) const {
    return overlap_quality(sheet_, sheet_, TrueMap(truth), to_correspondence(map));
  }
  OverlapErrors errors(const TrueMap& truth, const SurfaceMap& map) const {
    return overlap_errors(sheet_, sheet_, truth, map);
  }

  const Shape sheet_{test::sheet(kColumns, kRows, kColumns* kCell, kRows* kCell)};
  const double unit_ = kCell / std::sqrt(sheet_.area());
};

TEST_F(SheetOverlap, WholeMapsOverlapAndLeaveNothing) {
  const OverlapQuality whole = quality(identity(sheet_), identity(sheet_));
  EXPECT_EQ(whole.both, 1);
  EXPECT_EQ(whole.iou(), 1);
  EXPECT_FALSE(whole.unmatched_precision());
  EXPECT_FALSE(whole.unmatched_recall());
}

TEST_F(SheetOverlap, SharesAreAreas) {
  // Truth: columns 0 to 10, map: 5 to 20. A column inside stands for a cell's width, at the border
  // for half of one; what lies on the columns' ends is shared.
  const OverlapQuality part = quality(columns(0, 10), columns(5, 20));
  EXPECT_NEAR(part.both, 6.0 / 20, kSumRounding);
  EXPECT_NEAR(part.only_matched, 9.5 / 20, kSumRounding);
  EXPECT_NEAR(part.only_true, 4.5 / 20, kSumRounding);
  EXPECT_NEAR(part.neither, 0, kSumRounding);
  EXPECT_NEAR(part.matched(), 15.5 / 20, kSumRounding);
  EXPECT_NEAR(part.truly_matched(), 10.5 / 20, kSumRounding);
  EXPECT_NEAR(part.iou().value(), 6.0 / 20, kSumRounding);
  EXPECT_EQ(part.unmatched_precision(), 0);
  EXPECT_EQ(part.unmatched_recall(), 0);
}

TEST_F(SheetOverlap, PrecisionAndRecallAreOfTheUnmatched) {
  // Unmatched truly: columns 11 to 20, 9.5 cells; by the map: 15 to 20, 5.5, all of these.
  const OverlapQuality generous = quality(columns(0, 10), columns(0, 14));
  EXPECT_EQ(generous.unmatched_precision(), 1);
  EXPECT_NEAR(generous.unmatched_recall().value(), 5.5 / 9.5, kSumRounding);
  EXPECT_NEAR(generous.iou().value(), 10.5 / 14.5, kSumRounding);
  const OverlapQuality strict = quality(columns(0, 14), columns(0, 10));
  EXPECT_NEAR(strict.unmatched_precision().value(), 5.5 / 9.5, kSumRounding);
  EXPECT_EQ(strict.unmatched_recall(), 1);
  EXPECT_EQ(strict.iou(), generous.iou());
}

TEST_F(SheetOverlap, FiguresWithoutDenominatorAreAbsent) {
  const VertexMap none(sheet_.num_vertices(), kUnmatched);
  EXPECT_FALSE(quality(none, none).iou());
  EXPECT_EQ(quality(none, none).unmatched_precision(), 1);
  EXPECT_EQ(quality(none, none).unmatched_recall(), 1);
  EXPECT_EQ(quality(identity(sheet_), none).iou(), 0);
  EXPECT_EQ(quality(identity(sheet_), none).unmatched_precision(), 0);
  EXPECT_FALSE(quality(identity(sheet_), none).unmatched_recall());
  EXPECT_FALSE(quality(none, identity(sheet_)).unmatched_precision());
  EXPECT_FALSE(overlap_quality(sheet_, sheet_, GroundTruth{}, Correspondence{}).iou());
}

TEST_F(SheetOverlap, PointsAndVerticesHaveTheSameOverlap) {
  const TrueMap vertices = columns(0, 10), points = shifted_columns(0, 10, 0.3);
  const VertexMap map = columns(5, 14);
  const SurfaceMap map_points = shifted_columns(5, 14, 0.2);
  const OverlapQuality expected = quality(columns(0, 10), map);
  for (const TrueMap* truth : {&vertices, &points}) {
    EXPECT_EQ(overlap_quality(sheet_, sheet_, *truth, to_correspondence(map)).iou(),
              expected.iou());
    EXPECT_EQ(overlap_quality(sheet_, sheet_, *truth, map_points).iou(), expected.iou());
  }
}

TEST_F(SheetOverlap, TemplatePointsWeighTheSame) {
  const GroundTruth points{{0, 0, 1, 2, 3, kUnmatched}, {5, kUnmatched, kUnmatched, 2, 3, 4}};
  const Correspondence matches = {{0, 0}, {2, 2}};
  const OverlapQuality part = overlap_quality(sheet_, sheet_, points, matches);
  EXPECT_NEAR(part.both, 2.0 / 5, kSumRounding);
  EXPECT_NEAR(part.only_matched, 1.0 / 5, kSumRounding);
  EXPECT_NEAR(part.only_true, 1.0 / 5, kSumRounding);
  EXPECT_NEAR(part.neither, 1.0 / 5, kSumRounding);
  SurfaceMap map(sheet_.num_vertices());
  for (const int v : {0, 2}) map[v] = test::identity_map(sheet_.mesh())[v];
  EXPECT_EQ(overlap_quality(sheet_, sheet_, points, map).iou(), part.iou());
}

TEST_F(SheetOverlap, ErrorsAreThoseOfTheOverlap) {
  const OverlapErrors part = errors(columns(0, 10), shifted_columns(5, 14, 2.5));
  EXPECT_EQ(part.over_sqrt_area.samples, 6 * (kRows + 1));
  EXPECT_NEAR(part.over_sqrt_area.mean, 2.5 * unit_, kRounding);
  EXPECT_NEAR(part.over_sqrt_area.maximum, 2.5 * unit_, kRounding);
  EXPECT_NEAR(part.over_max_geodesic.mean, 2.5 * kCell / sheet_.max_geodesic(), kRounding);
  EXPECT_EQ(errors(columns(0, 4), shifted_columns(5, 14, 0)).over_sqrt_area.samples, 0);
}

TEST_F(SheetOverlap, TruthOnTrianglesIsExact) {
  const SurfaceMap truth = shifted_columns(0, 12, 0.3);
  EXPECT_EQ(errors(truth, truth).over_sqrt_area.maximum, 0);
  // Within a triangle, across an edge, and far along the grid.
  for (const double dx : {0.1, 0.4, 1.0, 4.7}) {
    const OverlapErrors shift = errors(truth, shifted_columns(0, 12, 0.3 + dx));
    EXPECT_NEAR(shift.over_sqrt_area.mean, dx * unit_, 1e-3 * unit_) << dx;
    EXPECT_NEAR(shift.over_sqrt_area.maximum, dx * unit_, 1e-3 * unit_) << dx;
  }
  const OverlapErrors of_vertices =
      overlap_errors(sheet_, sheet_, truth, to_correspondence(columns(0, 12)));
  EXPECT_NEAR(of_vertices.over_sqrt_area.mean, 0.3 * unit_, kRounding);
}

TEST_F(SheetOverlap, PointOnAnEdgeIsTheSameFromBothSides) {
  // The edge of both triangles of the first cell, from either.
  const Mesh& mesh = sheet_.mesh();
  const auto neighbour = face_neighbours(mesh);
  SurfaceMap truth(sheet_.num_vertices()), map = truth;
  const int corner = neighbour[0][0] != kNoFace ? 0 : neighbour[0][1] != kNoFace ? 1 : 2;
  const int across = neighbour[0][corner];
  const int a = mesh.faces[0][(corner + 1) % 3], b = mesh.faces[0][(corner + 2) % 3];
  truth[0] = {0, {}};
  map[0] = {across, {}};
  const auto weigh = [&](SurfacePoint& point, int vertex, double weight) {
    const Face& face = mesh.faces[point.face];
    point.weights[std::ranges::find(face, vertex) - face.begin()] = weight;
  };
  for (SurfacePoint* point : {&truth[0], &map[0]}) {
    weigh(*point, a, 0.375);
    weigh(*point, b, 0.625);
  }
  EXPECT_LT(errors(truth, map).over_sqrt_area.maximum, kSumRounding);
}

TEST_F(SheetOverlap, ErrorsOfVerticesAreNotANumberOffTheOverlap) {
  const TrueMap truth = columns(0, 10);
  const Correspondence matches = {{3, 3}, {4, 5}, {4, 7}, {15, 15}};
  const std::vector<double> errors = vertex_errors(sheet_, sheet_, truth, matches);
  ASSERT_EQ(std::ssize(errors), sheet_.num_vertices());
  EXPECT_EQ(errors[3], 0);
  EXPECT_NEAR(errors[4], 2 * unit_, kRounding);
  EXPECT_EQ(std::ranges::count_if(errors, [](double e) { return std::isnan(e); }),
            sheet_.num_vertices() - 2);
}

TEST_F(SheetOverlap, BadInputThrows) {
  const int outside = sheet_.num_vertices();
  VertexMap wrong = identity(sheet_);
  wrong[3] = outside;
  EXPECT_THROW(quality(wrong, identity(sheet_)), InvalidInput);
  wrong[3] = -2;
  EXPECT_THROW(quality(wrong, identity(sheet_)), InvalidInput);
  EXPECT_THROW(quality({0, 1}, identity(sheet_)), InvalidInput);
  SurfaceMap points(outside);
  points[0].face = sheet_.mesh().num_faces();
  EXPECT_THROW(errors(points, SurfaceMap(outside)), InvalidInput);
  EXPECT_THROW(errors(SurfaceMap(outside), points), InvalidInput);
  EXPECT_THROW(
      overlap_errors(sheet_, sheet_, columns(0, 3), Correspondence{{0, 0}}, {.max_samples = 0}),
      InvalidInput);
  EXPECT_THROW(overlap_quality(sheet_, sheet_, GroundTruth{{0, 1}, {0}}, Correspondence{}),
               InvalidInput);
}

/// A random map between two rough spheres that leaves a share of the vertices out.
class RandomOverlap : public testing::Test {
 protected:
  VertexMap random_map(double unmatched) {
    VertexMap map(source_.num_vertices());
    for (int& v : map)
      v = random_.uniform() < unmatched ? kUnmatched : random_.index(target_.num_vertices());
    return map;
  }

  test::Random random_{7};
  const Shape source_{test::rough_sphere(3, 0.2, 5)}, target_{test::rough_sphere(2, 0.1, 6)};
};

TEST_F(RandomOverlap, QualityIsThatOfCountingTriangles) {
  const VertexMap truth = random_map(0.3), map = random_map(0.4);
  double both = 0, either = 0, neither = 0, unmatched = 0, lacking = 0;
  const Mesh& mesh = source_.mesh();
  for (const Face& face : mesh.faces) {
    const Point& a = mesh.vertices[face[0]];
    const double third = (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a).norm() / 6;
    for (const int v : face) {
      const bool matched = map[v] != kUnmatched, truly = truth[v] != kUnmatched;
      if (matched && truly) both += third;
      if (matched || truly) either += third;
      if (!matched && !truly) neither += third;
      if (!matched) unmatched += third;
      if (!truly) lacking += third;
    }
  }
  const OverlapQuality quality =
      overlap_quality(source_, target_, TrueMap(truth), to_correspondence(map));
  EXPECT_NEAR(quality.iou().value(), both / either, 1e-9);
  EXPECT_NEAR(quality.unmatched_precision().value(), neither / unmatched, 1e-9);
  EXPECT_NEAR(quality.unmatched_recall().value(), neither / lacking, 1e-9);
}

TEST_F(RandomOverlap, ErrorsAreThoseOfTheTruthWithoutWhatIsUnmatched) {
  const VertexMap truth = random_map(0.3), map = random_map(0.4);
  GroundTruth points;
  for (int v = 0; v < source_.num_vertices(); ++v) {
    points.source.push_back(v);
    points.target.push_back(truth[v]);
  }
  const Correspondence matches = to_correspondence(map);
  const OverlapErrors errors = overlap_errors(source_, target_, TrueMap(truth), matches);
  const ErrorStatistics expected = template_errors(source_, target_, points, matches);
  EXPECT_EQ(errors.over_sqrt_area.samples, expected.samples);
  EXPECT_NEAR(errors.over_sqrt_area.mean, expected.mean, kRounding);
  EXPECT_NEAR(errors.over_sqrt_area.p95, expected.p95, kRounding);
  EXPECT_NEAR(errors.over_max_geodesic.mean, match_errors(source_, target_, points, matches).mean,
              kRounding);
  const SurfaceMap map_points = corner_points(target_.mesh(), map);
  EXPECT_NEAR(overlap_errors(source_, target_, TrueMap(truth), map_points).over_sqrt_area.mean,
              point_errors(source_, target_, points, map_points).mean, kRounding);
}

TEST_F(RandomOverlap, ScaleAndPlaceDoNotMatter) {
  const TrueMap truth = corner_points(target_.mesh(), random_map(0.3));
  const Correspondence matches = to_correspondence(random_map(0.4));
  const Shape source(test::scaled(test::moved(source_.mesh(), random_), 7));
  const Shape target(test::scaled(test::moved(target_.mesh(), random_), 0.1));
  EXPECT_NEAR(overlap_quality(source, target, truth, matches).iou().value(),
              overlap_quality(source_, target_, truth, matches).iou().value(), 1e-9);
  EXPECT_NEAR(overlap_errors(source, target, truth, matches).over_sqrt_area.mean,
              overlap_errors(source_, target_, truth, matches).over_sqrt_area.mean, 1e-4);
}

TEST_F(RandomOverlap, ThreadsChangeNothing) {
  const TrueMap truth = corner_points(target_.mesh(), random_map(0.3));
  const Correspondence matches = to_correspondence(random_map(0.4));
  const auto errors = [&](int threads) {
    Context context;
    context.threads = threads;
    return overlap_errors(source_, target_, truth, matches, {}, context).over_sqrt_area.errors;
  };
  EXPECT_EQ(errors(1), errors(3));
}

TEST(Overlap, VerticesOffTheSurfaceDoNotCount) {
  const Mesh mesh = test::sphere_with_unreferenced_vertices();
  const Shape shape(mesh);
  VertexMap all = identity(shape), truth = all;
  for (int v = 0; v < shape.num_vertices(); ++v)
    if (!shape.on_surface(v)) truth[v] = kUnmatched;
  const OverlapQuality whole =
      overlap_quality(shape, shape, TrueMap(truth), to_correspondence(all));
  EXPECT_EQ(whole.both, 1);
  // A counterpart that is off the target's surface is none.
  const auto off = std::ranges::find(truth, kUnmatched) - truth.begin();
  const int on =
      static_cast<int>(std::ranges::find_if(truth, [](int v) { return v >= 0; }) - truth.begin());
  all[on] = truth[on] = static_cast<int>(off);
  const OverlapQuality part = overlap_quality(shape, shape, TrueMap(truth), to_correspondence(all));
  EXPECT_GT(part.neither, 0);
  EXPECT_EQ(part.iou(), 1);
}

TEST(Overlap, VertexWhoseFirstFaceIsNotPartOfTheSurfaceHasItsPlace) {
  Mesh mesh = test::icosphere(2);
  mesh.faces.insert(mesh.faces.begin(), Face{0, 0, 1});
  const Shape shape(mesh);
  const VertexMap all = identity(shape);
  EXPECT_EQ(overlap_quality(shape, shape, TrueMap(all), to_correspondence(all)).both, 1);
  EXPECT_EQ(
      overlap_errors(shape, shape, TrueMap(all), to_correspondence(all)).over_sqrt_area.samples,
      shape.num_vertices());
}

TEST(Overlap, CopiesAtASeamCountOnce) {
  const Mesh sphere = test::icosphere(2);
  const Shape shape(test::split_charts(sphere, test::octants(sphere)));
  const VertexMap all = identity(shape);
  const Correspondence matches = to_correspondence(all);
  EXPECT_EQ(overlap_errors(shape, shape, TrueMap(all), matches).over_sqrt_area.samples,
            sphere.num_vertices());
  EXPECT_EQ(overlap_quality(shape, shape, TrueMap(all), matches).iou(), 1);
}

}  // namespace
}  // namespace isomatch
