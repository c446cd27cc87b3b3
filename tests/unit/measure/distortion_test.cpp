// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "measure/spread_matches.h"
#include "shape/prepared_shape.h"
#include "support/metric_surface.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"

namespace isomatch {
namespace {

Correspondence identity(const Shape& shape) {
  Correspondence matches;
  for (int v = 0; v < shape.num_vertices(); ++v) matches.push_back({v, v});
  return matches;
}

/// `count` matches between random vertices, many-to-many.
Correspondence random_matches(const Shape& source, const Shape& target, int count,
                              test::Random& random) {
  Correspondence matches;
  for (int i = 0; i < count; ++i)
    matches.push_back({random.index(source.num_vertices()), random.index(target.num_vertices())});
  std::ranges::sort(matches);
  matches.erase(std::unique(matches.begin(), matches.end()), matches.end());
  return matches;
}

/// Equation 2 as it stands, with xi' the whole correspondence but the match itself.
double d_iso(const Shape& source, const Shape& target, const Correspondence& matches,
             const Match& match) {
  const GeodesicGraph source_graph(source.mesh()), target_graph(target.mesh());
  GeodesicSearch on_source(source_graph), on_target(target_graph);
  double sum = 0;
  for (const auto& [s, t] : matches) {
    if (Match{s, t} == match) continue;
    sum += std::abs(on_source.distance(s, match.source) / source.max_geodesic() -
                    on_target.distance(t, match.target) / target.max_geodesic());
  }
  return sum / static_cast<double>(matches.size() - 1);
}

TEST(IsometricDistortion, IdentityHasNone) {
  const Shape shape(test::rough_sphere(3, 0.2, 1));
  const IsometricDistortion distortion = isometric_distortion(shape, shape, identity(shape));
  EXPECT_EQ(distortion.mean, 0);
  EXPECT_EQ(distortion.maximum, 0);
}

TEST(IsometricDistortion, TurnedCylinderHasNone) {
  constexpr int kSegments = 20;
  const Shape cylinder(test::open_cylinder(kSegments, 8));
  Correspondence turned;
  for (int v = 0; v < cylinder.num_vertices(); ++v)
    turned.push_back({v, v / kSegments * kSegments + (v + 3) % kSegments});
  const IsometricDistortion distortion = isometric_distortion(cylinder, cylinder, turned);
  // Equal distances are sums of floats in another order.
  EXPECT_LT(distortion.maximum, 1e-5);
}

TEST(IsometricDistortion, EqualsEquationsOneTwoAndFour) {
  test::Random random(2);
  const Shape source(test::rough_sphere(2, 0.3, 3));
  const Shape target(test::sheet(9, 14, 2, 3));
  const Correspondence matches = random_matches(source, target, 120, random);
  const int all = static_cast<int>(matches.size());
  const auto distortion = isometric_distortion(source, target, matches, {.list_size = all});
  ASSERT_EQ(distortion.per_match.size(), matches.size());
  double sum = 0, maximum = 0;
  for (std::size_t m = 0; m < matches.size(); ++m) {
    const double expected = d_iso(source, target, matches, matches[m]);
    EXPECT_NEAR(distortion.per_match[m], expected, 1e-6);
    sum += expected;
    maximum = std::max(maximum, expected);
  }
  EXPECT_NEAR(distortion.mean, sum / all, 1e-6);
  EXPECT_NEAR(distortion.maximum, maximum, 1e-6);
}

TEST(IsometricDistortion, ListLongerThanOneBlockOfFieldsIsExactToo) {
  test::Random random(3);
  const Shape source(test::icosphere(2));
  const Shape target(test::torus(12, 9));
  const Correspondence matches = random_matches(source, target, 70, random);
  const auto distortion = isometric_distortion(source, target, matches, {.list_size = 1000});
  for (std::size_t m = 0; m < matches.size(); m += 7)
    EXPECT_NEAR(distortion.per_match[m], d_iso(source, target, matches, matches[m]), 1e-6);
}

TEST(IsometricDistortion, ShortListIsCloseToAllMatches) {
  test::Random random(4);
  const Shape shape(test::rough_sphere(3, 0.2, 7));
  Correspondence matches;
  for (int v = 0; v < shape.num_vertices(); ++v)
    matches.push_back({v, std::max(0, v - random.index(30))});
  const double exact =
      isometric_distortion(shape, shape, matches, {.list_size = shape.num_vertices()}).mean;
  const double approximate = isometric_distortion(shape, shape, matches, {.list_size = 200}).mean;
  // 200 of 642 entries, d_iso scatters among entries about as much as its mean: 1 / sqrt(200) = 7
  // %.
  EXPECT_NEAR(approximate, exact, 0.1 * exact);
}

TEST(IsometricDistortion, ScalePositionAndNumbersDoNotMatter) {
  test::Random random(5);
  const Mesh mesh = test::rough_sphere(2, 0.3, 9), other = test::torus(12, 8);
  const Shape source(mesh), target(other);
  const auto relabelled = test::relabelled(test::scaled(test::moved(other, random), 0.3), random);
  const Shape moved(relabelled.mesh);
  Correspondence input, relabelled_input;
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const int t = random.index(other.num_vertices());
    input.push_back({v, t});
    relabelled_input.push_back({v, relabelled.new_vertex[t]});
  }
  const DistortionOptions all{.list_size = 1000};
  const auto a = isometric_distortion(source, target, input, all);
  const auto b = isometric_distortion(source, moved, relabelled_input, all);
  EXPECT_NEAR(a.mean, b.mean, 1e-4);
  EXPECT_NEAR(a.maximum, b.maximum, 1e-4);
}

TEST(IsometricDistortion, ThreadsChangeNothing) {
  test::Random random(6);
  const Shape source(test::rough_sphere(3, 0.2, 1));
  const Shape target(test::torus(30, 20));
  const Correspondence matches = random_matches(source, target, 3000, random);
  Context one, many;
  one.threads = 1;
  many.threads = 5;
  const DistortionOptions options{.list_size = 50};
  EXPECT_EQ(isometric_distortion(source, target, matches, options, one).per_match,
            isometric_distortion(source, target, matches, options, many).per_match);
}

TEST(IsometricDistortion, FewMatches) {
  const Shape sheet(test::sheet(4, 4));
  EXPECT_EQ(isometric_distortion(sheet, sheet, {}).mean, 0);
  EXPECT_EQ(isometric_distortion(sheet, sheet, {{3, 5}}).mean, 0);
  // The list has one entry, one match is that entry, the other is measured against it.
  const auto two = isometric_distortion(sheet, sheet, {{0, 0}, {9, 0}}, {.list_size = 1});
  EXPECT_EQ(std::ranges::count(two.per_match, 0.0), 1);
  EXPECT_GT(two.maximum, 0);
}

TEST(IsometricDistortion, BadInputThrows) {
  const Shape sheet(test::sheet(4, 4));
  EXPECT_THROW(isometric_distortion(sheet, sheet, {{0, 25}}), InvalidInput);
  EXPECT_THROW(isometric_distortion(sheet, sheet, {{-1, 0}}), InvalidInput);
  EXPECT_THROW(isometric_distortion(sheet, sheet, {{0, 0}}, {.list_size = 0}), InvalidInput);
}

TEST(IsometricDistortion, OrderAndRepetitionDoNotMatter) {
  test::Random random(8);
  const Shape source(test::icosphere(2)), target(test::torus(12, 9));
  const Correspondence matches = random_matches(source, target, 60, random);
  const auto sorted = isometric_distortion(source, target, matches);
  Correspondence shuffled;
  for (int place : random.permutation(static_cast<int>(matches.size())))
    shuffled.push_back(matches[place]);
  shuffled.push_back(shuffled.front());
  const auto other = isometric_distortion(source, target, shuffled);
  EXPECT_EQ(other.mean, sorted.mean);
  EXPECT_EQ(other.maximum, sorted.maximum);
  ASSERT_EQ(other.per_match.size(), shuffled.size());
  for (std::size_t m = 0; m < shuffled.size(); ++m) {
    const auto place = std::ranges::lower_bound(matches, shuffled[m]) - matches.begin();
    EXPECT_EQ(other.per_match[m], sorted.per_match[place]);
  }
}

TEST(IsometricDistortion, CopiesAtASeamAreOneMatchAndOthersHaveNone) {
  const Mesh sphere = test::rough_sphere(2, 0.2, 1);
  const Mesh charts = test::split_charts(sphere, test::octants(sphere));
  Mesh loose = charts;
  loose.vertices.emplace_back(9, 9, 9);
  const Shape source(loose), target(sphere);
  Correspondence matches;
  for (int v = 0; v < loose.num_vertices(); ++v)
    matches.push_back({v, v * 7 % sphere.num_vertices()});
  for (int v = 0; v < charts.num_vertices(); ++v)
    matches[v].target = matches[source.copies(v).front()].target;
  Correspondence single;
  for (const Match& match : matches)
    if (source.on_surface(match.source) && source.copies(match.source).front() == match.source)
      single.push_back(match);
  ASSERT_LT(single.size(), matches.size() - 50);
  const auto all = isometric_distortion(source, target, matches);
  const auto once = isometric_distortion(source, target, single);
  EXPECT_EQ(all.mean, once.mean);
  EXPECT_EQ(all.maximum, once.maximum);
  EXPECT_TRUE(std::isnan(all.per_match.back()));
  for (int v = 0; v < charts.num_vertices(); ++v)
    EXPECT_EQ(all.per_match[v], all.per_match[source.copies(v).front()]);
}

TEST(IsometricDistortion, StopIsHeeded) {
  const Shape sheet(test::sheet(4, 4));
  std::stop_source stop;
  stop.request_stop();
  Context context;
  context.stop = stop.get_token();
  EXPECT_THROW(isometric_distortion(sheet, sheet, {{0, 0}}, {}, context), Cancelled);
}

TEST(EvenlySpacedMatches, AreFarApart) {
  const MetricSurface sheet = test::metric_surface(test::sheet(20, 20));
  Correspondence identity;
  for (int v = 0; v < sheet.num_vertices(); ++v) identity.push_back({v, v});
  const std::vector<Match> four = evenly_spaced_matches(sheet, SurfaceMatches(identity), 4);
  ASSERT_EQ(four.size(), 4u);
  // The four corners of the unit square, about its centre.
  for (const Match& match : four) {
    const Point& p = sheet.mesh().vertices[match.source];
    EXPECT_NEAR(std::abs(p.x()), 0.5, 1e-12);
    EXPECT_NEAR(std::abs(p.y()), 0.5, 1e-12);
  }
}

TEST(EvenlySpacedMatches, TakeOneMatchOfAVertex) {
  const MetricSurface sheet = test::metric_surface(test::sheet(3, 3));
  const SurfaceMatches matches(Correspondence{{0, 2}, {0, 3}, {5, 1}, {5, 9}, {5, 10}});
  EXPECT_EQ(evenly_spaced_matches(sheet, matches, 5), *matches);
  EXPECT_THAT(evenly_spaced_matches(sheet, matches, 4),
              testing::UnorderedElementsAre(Match{0, 2}, Match{5, 1}));
}

}  // namespace
}  // namespace isomatch
