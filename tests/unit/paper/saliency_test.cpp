// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/saliency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "support/context.h"
#include "support/metric_surface.h"
#include "support/random.h"
#include "support/rough_meshes.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

constexpr double kPi = std::numbers::pi;
/// Angle defects as they are, without smoothing.
constexpr SaliencyOptions kRaw{.curvature_scale = 0};

/// Integral of the Gaussian curvature over the surface.
double total_curvature(const MetricSurface& shape, const SaliencyOptions& options) {
  const std::vector<double> curvature = gaussian_curvature(shape, options);
  double sum = 0;
  for (int v = 0; v < shape.num_vertices(); ++v) sum += curvature[v] * shape.vertex_areas()[v];
  return sum;
}

double largest_magnitude(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Largest difference between `a` and `b`, in which each vertex has the number `vertex_in_b`.
double largest_difference(const std::vector<double>& a, const std::vector<double>& b,
                          const std::vector<int>& vertex_in_b) {
  double largest = 0;
  for (std::size_t v = 0; v < vertex_in_b.size(); ++v)
    largest = std::max(largest, std::abs(a[v] - b[vertex_in_b[v]]));
  return largest;
}

TEST(IntegralGeodesicDistance, IsHalfEverywhereOnASphere) {
  // The mean distance on a sphere is pi R / 2, the largest pi R. 150 cells have a radius of about
  // .16 R, within which the mean of g departs by less than half a percent of the largest from g at
  // the cell's point.
  for (const double radius : {1.0, 20.0}) {
    const Shape sphere(test::icosphere(3, radius));
    const std::vector<double> integral = integral_geodesic_distance(sphere);
    ASSERT_EQ(integral.size(), sphere.num_vertices());
    for (const double value : integral) ASSERT_NEAR(value, 0.5, 0.01);
  }
}

TEST(IntegralGeodesicDistance, IsExactIfEveryVertexIsAPoint) {
  const MetricSurface sphere = test::metric_surface(test::icosphere(2));
  const int n = sphere.num_vertices();
  std::vector<int> vertices(n);
  for (int v = 0; v < n; ++v) vertices[v] = v;
  const std::vector<float> fields = geodesic_fields(sphere.graph(), vertices);
  const std::vector<double> integral =
      integral_geodesic_distance(sphere, {.integral_points = 10 * n});
  for (int v = 0; v < n; ++v) {
    double sum = 0;
    for (int p = 0; p < n; ++p) sum += sphere.vertex_areas()[p] * fields[p * n + v];
    EXPECT_NEAR(integral[v], sum / sphere.max_geodesic(), 1e-6);
  }
}

TEST(IntegralGeodesicDistance, FollowsAParabolaAlongALongTube) {
  constexpr double kHeight = 20;
  const Mesh tube = test::closed_cylinder(16, 80, 1, kHeight);
  const Shape shape(tube);
  const std::vector<double> integral = integral_geodesic_distance(shape);
  const auto height = [&](int v) { return tube.vertices[v].z(); };
  for (int v = 0; v < shape.num_vertices(); ++v) {
    // On a segment of length 1, the integral of |x - y| over y. A girth of pi and caps of radius 1
    // change distances by up to that over the length of about 21, most of them by much less.
    const double x = height(v) / kHeight;
    EXPECT_NEAR(integral[v], (x * x + (1 - x) * (1 - x)) / 2, 0.06);
  }
  const std::vector<int> order = descending_order(integral);
  for (int rank = 0; rank < 10; ++rank)
    EXPECT_GT(std::abs(height(order[rank]) - kHeight / 2), 0.95 * kHeight / 2);
  EXPECT_LT(std::abs(height(order.back()) - kHeight / 2), 0.1 * kHeight / 2);
}

TEST(IntegralGeodesicDistance, ThreadsChangeNothing) {
  const Shape shape(test::jittered_torus(24, 12, 0.3, 1));
  EXPECT_EQ(integral_geodesic_distance(shape, {}, test::with_threads(1)),
            integral_geodesic_distance(shape, {}, test::with_threads(3)));
}

TEST(IntegralGeodesicDistance, ScaleMotionAndNumberingChangeNothing) {
  const Mesh mesh = test::rough_torus(40, 16, 0.1, 7);
  test::Random random(1);
  const test::Relabelled copy = test::relabelled(test::scaled(mesh, 7), random);
  const Shape a(mesh), b(copy.mesh), c(test::moved(copy.mesh, random));
  const std::vector<double> integral = integral_geodesic_distance(a);
  const auto difference = [&](const Shape& other) {
    return largest_difference(integral, integral_geodesic_distance(other), copy.new_vertex);
  };
  // Rounding of distances to float; with other points on the surface it would be about .001.
  EXPECT_LT(difference(b), 1e-5);
  EXPECT_LT(difference(c), 1e-5);
}

TEST(GaussianCurvature, IsFourPiOverTheAreaOnASphere) {
  for (const double radius : {0.1, 3.0}) {
    const Shape sphere(test::icosphere(4, radius));
    // Angle defects on an icosphere are uneven by the shares of the area that thirds of the faces
    // give; the smoothing, over about two edges, evens them out.
    for (const double value : gaussian_curvature(sphere))
      EXPECT_NEAR(value, 4 * kPi, 0.04 * 4 * kPi);
  }
}

TEST(GaussianCurvature, IsZeroOnAPlaneAndOnARolledSheet) {
  for (const Mesh& mesh : {test::sheet(20, 20), test::rolled_sheet(60, 20, 3, 1, 5)}) {
    const Shape shape(mesh);
    EXPECT_LT(largest_magnitude(gaussian_curvature(shape)), 1e-6);
    EXPECT_LT(largest_magnitude(gaussian_curvature(shape, kRaw)), 1e-6);
  }
}

TEST(GaussianCurvature, HasTheSumOfGaussAndBonnet) {
  const auto expect_total = [](const Mesh& mesh, double expected) {
    const MetricSurface shape = test::metric_surface(mesh);
    EXPECT_NEAR(total_curvature(shape, kRaw), expected, 1e-9);
    // Heat flow keeps the sum up to the residual of the solver.
    EXPECT_NEAR(total_curvature(shape, {}), expected, 1e-4);
  };
  expect_total(test::rough_sphere(3, 0.2, 5), 4 * kPi);
  expect_total(test::closed_cylinder(20, 10), 4 * kPi);
  expect_total(test::box(6), 4 * kPi);
  expect_total(test::rough_torus(30, 12, 0.2, 3), 0);
  expect_total(test::sliver_torus(30, 12, 0.1, 3), 0);
}

TEST(GaussianCurvature, SitsInTheCornersOfABox) {
  const Mesh box = test::box(8);
  const Shape shape(box);
  const std::vector<double> areas = vertex_areas(box);
  const std::vector<double> smooth = gaussian_curvature(shape),
                            raw = gaussian_curvature(shape, kRaw);
  const auto is_corner = [&](int v) {
    const Point& p = box.vertices[v];
    return (p.array() * (1 - p.array())).abs().maxCoeff() < 1e-9;
  };
  const std::vector<int> order = descending_order(smooth);
  for (int rank = 0; rank < 8; ++rank) EXPECT_TRUE(is_corner(order[rank]));
  for (int v = 0; v < shape.num_vertices(); ++v) {
    const double expected = is_corner(v) ? kPi / 2 / areas[v] * 6 : 0;
    EXPECT_NEAR(raw[v], expected, 1e-6);
  }
}

TEST(GaussianCurvature, CountsNoAngleDefectOnABoundary) {
  const Shape shape(test::sphere_with_hole());
  const std::vector<double> raw = gaussian_curvature(shape, kRaw);
  // Three vertices round the missing triangle; the others of the sphere are convex.
  EXPECT_EQ(std::ranges::count(raw, 0.0), 3);
  EXPECT_TRUE(std::ranges::all_of(raw, [](double value) { return value >= 0; }));
  EXPECT_EQ(largest_magnitude(gaussian_curvature(Shape(test::sheet(1, 1)), kRaw)), 0);
}

TEST(GaussianCurvature, ScaleMotionAndNumberingChangeNothing) {
  const Mesh mesh = test::rough_sphere(3, 0.1, 2);
  test::Random random(2);
  const test::Relabelled copy = test::relabelled(test::scaled(mesh, 100), random);
  const Shape a(mesh), b(test::moved(copy.mesh, random));
  const std::vector<double> curvature = gaussian_curvature(a);
  // Up to the residual of the solver and rounding of coordinates ten times the size of the shape.
  EXPECT_LT(largest_difference(curvature, gaussian_curvature(b), copy.new_vertex),
            1e-5 * largest_magnitude(curvature));
}

TEST(GaussianCurvature, IsFiniteOnEveryMesh) {
  for (const test::ZooMesh& zoo_mesh : test::mesh_zoo()) {
    SCOPED_TRACE(zoo_mesh.name);
    const Shape shape(zoo_mesh.mesh);
    const std::vector<double> curvature = gaussian_curvature(shape),
                              integral = integral_geodesic_distance(shape);
    ASSERT_EQ(curvature.size(), shape.num_vertices());
    ASSERT_EQ(integral.size(), shape.num_vertices());
    for (int v = 0; v < shape.num_vertices(); ++v) {
      ASSERT_EQ(std::isfinite(curvature[v]), shape.on_surface(v));
      ASSERT_EQ(std::isfinite(integral[v]), shape.on_surface(v));
      if (!shape.on_surface(v)) continue;
      ASSERT_GE(integral[v], 0);
      ASSERT_LE(integral[v], 1);
    }
  }
}

TEST(DescendingOrder, PutsTheLowerOfEqualsFirst) {
  EXPECT_EQ(descending_order(std::vector<double>{1, 3, 2, 3, 1}), (std::vector{1, 3, 2, 0, 4}));
  EXPECT_EQ(descending_order({}), std::vector<int>{});
}

TEST(DescendingOrder, LeavesOutWhatHasNoSaliency) {
  const double none = std::nan("");
  EXPECT_EQ(descending_order(std::vector<double>{none, -3, none, 2}), (std::vector{3, 1}));
}

TEST(SaliencyOptions, AreChecked) {
  EXPECT_NO_THROW(SaliencyOptions{}.validate());
  const Shape sphere(test::icosphere(1));
  EXPECT_THROW(integral_geodesic_distance(sphere, {.integral_points = 0}), InvalidInput);
  EXPECT_THROW(gaussian_curvature(sphere, {.curvature_scale = -0.1}), InvalidInput);
  EXPECT_THROW(gaussian_curvature(sphere, {.curvature_scale = 1.1}), InvalidInput);
  EXPECT_THROW(gaussian_curvature(sphere, {.curvature_scale = std::nan("")}), InvalidInput);
}

}  // namespace
}  // namespace isomatch
