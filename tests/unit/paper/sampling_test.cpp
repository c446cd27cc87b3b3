// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/methods/sampling.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"
#include "support/context.h"
#include "support/metric_surface.h"
#include "support/random.h"
#include "support/rough_meshes.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A shape with the distances between all vertices and a random order of saliency.
struct MeasuredShape {
  explicit MeasuredShape(const Mesh& mesh, std::uint64_t seed)
      : shape(test::metric_surface(mesh)),
        order(test::Random(seed).permutation(shape.num_vertices())) {
    std::vector<int> vertices(shape.num_vertices());
    std::iota(vertices.begin(), vertices.end(), 0);
    fields = geodesic_fields(shape.graph(), vertices);
  }

  float distance(int from, int to) const {
    return fields[static_cast<std::size_t>(from) * shape.num_vertices() + to];
  }

  MetricSurface shape;
  std::vector<int> order;
  std::vector<float> fields;
};

std::vector<MeasuredShape> measured_shapes() {
  std::vector<MeasuredShape> shapes;
  shapes.emplace_back(test::rough_sphere(3, 0.2, 1), 1);
  shapes.emplace_back(test::jittered_torus(30, 14, 0.3, 2), 2);
  shapes.emplace_back(test::holed_terrain(20, 0.05, 3), 3);
  return shapes;
}

/// Section 3 in the words of the paper, on the table of distances.
std::vector<int> plainly_sampled(const MeasuredShape& measured, std::span<const int> inherited,
                                 float radius) {
  std::vector<int> bases(inherited.begin(), inherited.end());
  const auto is_covered = [&](int v) {
    return std::ranges::any_of(bases, [&](int b) { return measured.distance(b, v) <= radius; });
  };
  for (int v : measured.order) {
    if (!is_covered(v)) bases.push_back(v);
  }
  return bases;
}

double area_of_patch(const MeasuredShape& measured, int base, float radius) {
  double area = 0;
  for (int v = 0; v < measured.shape.num_vertices(); ++v) {
    if (measured.distance(base, v) <= radius) area += measured.shape.vertex_areas()[v];
  }
  return area;
}

void expect_sampled(const MeasuredShape& measured, const BaseSampling& sampling,
                    std::span<const int> inherited) {
  EXPECT_EQ(sampling.bases, plainly_sampled(measured, inherited, sampling.radius));
  double largest = 0;
  for (int base : sampling.bases)
    largest = std::max(largest, area_of_patch(measured, base, sampling.radius));
  EXPECT_NEAR(sampling.largest_patch_area, largest, 1e-12);
}

/// Smallest distance between two of `bases` as from the earlier one.
float least_distance(const MeasuredShape& measured, const std::vector<int>& bases) {
  float least = kInfinity;
  for (std::size_t b = 0; b < bases.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a)
      least = std::min(least, measured.distance(bases[a], bases[b]));
  }
  return least;
}

/// Largest distance from a vertex to the nearest of `bases`.
float covering_radius(const MeasuredShape& measured, const std::vector<int>& bases) {
  float largest = 0;
  for (int v = 0; v < measured.shape.num_vertices(); ++v) {
    float nearest = kInfinity;
    for (int base : bases) nearest = std::min(nearest, measured.distance(base, v));
    largest = std::max(largest, nearest);
  }
  return largest;
}

TEST(SampleBases, IsThatOfThePlainAlgorithmOnEveryLevel) {
  for (const MeasuredShape& measured : measured_shapes()) {
    std::vector<int> inherited;
    for (const double share : {0.5, 0.3, 0.2, 0.1, 0.05}) {
      const float radius = static_cast<float>(share * measured.shape.max_geodesic());
      const BaseSampling sampling = sample_bases(measured.shape, measured.order, inherited, radius);
      EXPECT_EQ(sampling.radius, radius);
      expect_sampled(measured, sampling, inherited);
      inherited = sampling.bases;
    }
  }
}

TEST(SampleBases, SpreadsOverTheSurfaceEvenly) {
  for (const MeasuredShape& measured : measured_shapes()) {
    const float radius = static_cast<float>(0.15 * measured.shape.max_geodesic());
    const BaseSampling sampling = sample_bases(measured.shape, measured.order, {}, radius);
    EXPECT_GT(sampling.bases.size(), 10);
    EXPECT_GT(least_distance(measured, sampling.bases), radius);
    EXPECT_LE(covering_radius(measured, sampling.bases), radius);
  }
}

TEST(SampleBases, StartsFromTheInheritedBasesAndFollowsTheOrder) {
  const MeasuredShape measured(test::rough_sphere(3, 0.1, 4), 4);
  const std::vector<int> inherited{measured.order.back(), measured.order[100]};
  // .3 on a sphere of radius 1, whose area is 4 pi.
  const auto radius = static_cast<float>(0.3 / measured.shape.surface().scale);
  const BaseSampling sampling = sample_bases(measured.shape, measured.order, inherited, radius);
  ASSERT_GT(sampling.bases.size(), 10);
  EXPECT_TRUE(std::equal(inherited.begin(), inherited.end(), sampling.bases.begin()));
  const auto rank = [&](int v) { return std::ranges::find(measured.order, v); };
  for (std::size_t b = 3; b < sampling.bases.size(); ++b)
    EXPECT_LT(rank(sampling.bases[b - 1]), rank(sampling.bases[b]));
}

TEST(SampleBases, EndsAtEveryVertexInOrder) {
  const MeasuredShape measured(test::icosphere(2), 5);
  const BaseSampling all = sample_bases(measured.shape, measured.order, {}, 1e-3f);
  EXPECT_EQ(all.bases, measured.order);
  EXPECT_EQ(all.largest_patch_area, *std::ranges::max_element(measured.shape.vertex_areas()));
  const BaseSampling one = sample_bases(measured.shape, measured.order, {}, 100);
  EXPECT_EQ(one.bases, std::vector{measured.order.front()});
  EXPECT_NEAR(one.largest_patch_area, 1, 1e-12);
}

TEST(SampleBasesOfAShape, AreThoseOfItsSurfaceInTheNumbersAndUnitsOfTheMesh) {
  const Mesh sphere = test::rough_sphere(3, 0.2, 1);
  const Mesh charts = test::scaled(test::split_charts(sphere, test::octants(sphere)), 50);
  const Shape shape(test::combined(test::icosphere(1), charts));
  const Surface& surface = *shape.prepared().surface();
  std::vector<int> order;
  for (int v : test::Random(1).permutation(shape.num_vertices()))
    if (shape.on_surface(v)) order.push_back(v);
  std::vector<int> expected;
  const std::vector<int> on_it = *on_surface(surface, order, "vertex");
  for (int v :
       sample_bases(shape.prepared().metric({}), on_it, {}, static_cast<float>(20 / surface.scale))
           .bases)
    expected.push_back(surface.input_vertex[v]);
  EXPECT_GT(expected.size(), 10);
  EXPECT_EQ(sample_bases(shape, order, 20), expected);
  // All of them, each place once.
  EXPECT_EQ(std::ssize(sample_bases(shape, order, 0)), shape.num_surface_vertices());
}

TEST(SampleBasesOfAShape, HaveToBeOnItsSurface) {
  const Shape shape(test::three_spheres());
  EXPECT_THROW(sample_bases(shape, std::vector{0}, 1), InvalidInput);
  EXPECT_THROW(sample_bases(shape, std::vector{-1}, 1), InvalidInput);
  EXPECT_THROW(sample_bases(shape, std::vector{shape.num_vertices()}, 1), InvalidInput);
  EXPECT_EQ(sample_bases(shape, std::vector{170}, 1), std::vector{170});
}

/// Farthest point sampling on the table of distances.
std::vector<int> plainly_farthest(const MeasuredShape& measured, const std::vector<int>& candidates,
                                  int count) {
  std::vector<int> places{0};
  while (static_cast<int>(places.size()) < count) {
    float farthest = 0;
    int next = -1;
    for (int place = 0; place < static_cast<int>(candidates.size()); ++place) {
      float nearest = kInfinity;
      for (int other : places)
        nearest = std::min(nearest, measured.distance(candidates[other], candidates[place]));
      if (nearest > farthest) {
        farthest = nearest;
        next = place;
      }
    }
    if (next < 0) break;
    places.push_back(next);
  }
  return places;
}

TEST(FarthestPoints, AreThoseOfThePlainAlgorithm) {
  for (const MeasuredShape& measured : measured_shapes()) {
    const std::vector<int> some(measured.order.begin(), measured.order.begin() + 60);
    for (const int count : {1, 2, 20, 60, 1000}) {
      EXPECT_EQ(farthest_points(measured.shape.graph(), some, count),
                plainly_farthest(measured, some, count));
    }
    EXPECT_EQ(farthest_points(measured.shape.graph(), measured.order, 40),
              plainly_farthest(measured, measured.order, 40));
  }
}

TEST(FarthestPoints, GiveTiesToTheEarlierPlace) {
  // From a corner of a square along its edges, the next corners are equally far.
  const Mesh mesh = test::sheet(4, 4);
  const GeodesicGraph graph(mesh, GeodesicOptions::edges());
  const int first = 0, right = 4, top = 20;
  EXPECT_EQ(farthest_points(graph, std::vector{first, right, top}, 2), (std::vector{0, 1}));
  EXPECT_EQ(farthest_points(graph, std::vector{first, top, right}, 2), (std::vector{0, 1}));
}

TEST(FarthestPoints, EndEarlyWhenAllAreTaken) {
  const Mesh mesh = test::icosphere(1);
  const GeodesicGraph graph(mesh);
  EXPECT_EQ(farthest_points(graph, std::vector{7, 7, 7}, 5), std::vector{0});
  const std::vector<int> repeated{7, 3, 7, 3};
  EXPECT_EQ(farthest_points(graph, repeated, 5), (std::vector{0, 1}));
  EXPECT_TRUE(farthest_points(graph, repeated, 0).empty());
}

void expect_measured(const MeasuredShape& measured, const std::vector<int>& bases,
                     const BaseNeighbourhoods& neighbourhoods) {
  const float cutoff = neighbourhoods.cutoff();
  for (int a = 0; a < static_cast<int>(bases.size()); ++a) {
    std::vector<int> near;
    for (int b = 0; b < static_cast<int>(bases.size()); ++b) {
      const float distance = measured.distance(bases[a], bases[b]);
      EXPECT_EQ(neighbourhoods.distance(a, b), std::min(distance, cutoff));
      if (distance <= cutoff) near.push_back(b);
    }
    std::vector<int> found;
    for (const auto& neighbour : neighbourhoods[a]) {
      found.push_back(neighbour.base);
      EXPECT_EQ(neighbour.distance, measured.distance(bases[a], bases[neighbour.base]));
    }
    EXPECT_EQ(found, near);
  }
}

TEST(BaseNeighbourhoods, HoldTheDistancesUpToTheCutoff) {
  for (const MeasuredShape& measured : measured_shapes()) {
    const std::vector<int> bases(measured.order.begin(), measured.order.begin() + 50);
    for (const float share : {0.f, 0.1f, 0.4f, 2.f}) {
      const float cutoff = share * static_cast<float>(measured.shape.max_geodesic());
      expect_measured(measured, bases, BaseNeighbourhoods(measured.shape, bases, cutoff));
    }
    expect_measured(measured, bases,
                    BaseNeighbourhoods(measured.shape, bases, std::numeric_limits<float>::max()));
  }
}

TEST(BaseNeighbourhoods, ThreadsChangeNothing) {
  const MeasuredShape measured(test::rough_sphere(3, 0.1, 6), 6);
  const BaseNeighbourhoods one(measured.shape, measured.order, 0.4f, test::with_threads(1));
  const BaseNeighbourhoods three(measured.shape, measured.order, 0.4f, test::with_threads(3));
  const auto same = [](const auto& x, const auto& y) {
    return x.base == y.base && x.distance == y.distance;
  };
  for (int b = 0; b < measured.shape.num_vertices(); ++b)
    ASSERT_TRUE(std::ranges::equal(one[b], three[b], same));
}

}  // namespace
}  // namespace isomatch
