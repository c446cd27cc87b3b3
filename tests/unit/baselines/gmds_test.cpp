// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "gmds/gmds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "gmds/coarse_start.h"
#include "gmds/stress.h"
#include "isomatch/error.h"
#include "pairs.h"
#include "support/context.h"
#include "support/metric_surface.h"
#include "support/shapes.h"

namespace isomatch::baselines {
namespace {

constexpr GmdsOptions kFewPoints{.points = 100};

SurfaceMatches nearest_matches(const MetricSurface& target, const GmdsResult& result) {
  const VertexMap nearest = nearest_vertices(target.mesh(), result.points);
  Correspondence matches;
  for (std::size_t i = 0; i < nearest.size(); ++i)
    matches.push_back({result.source_vertices[i], nearest[i]});
  std::ranges::sort(matches);
  return SurfaceMatches(matches);
}

TEST(Gmds, FindsARelabelledShape) {
  const test::KnownPair pair = test::relabelled_pair(1000);
  const GmdsResult result = match_gmds(pair.source_surface(), pair.target_surface(), kFewPoints);
  ASSERT_EQ(std::ssize(result.points), kFewPoints.points);
  // An edge is .04 long; distances within a triangle are interpolated.
  EXPECT_LT(result.stress, 0.004);
  EXPECT_LT(pair.error(nearest_matches(pair.target_surface(), result)), 0.02);
}

TEST(Gmds, PointsAreOnTriangles) {
  const test::KnownPair pair = test::posed_pair(1000);
  const GmdsResult result = match_gmds(pair.source_surface(), pair.target_surface(), kFewPoints);
  for (const SurfacePoint& point : result.points) {
    EXPECT_GE(point.face, 0);
    EXPECT_GE(*std::ranges::min_element(point.weights), 0);
    EXPECT_NEAR(std::accumulate(point.weights.begin(), point.weights.end(), 0.0), 1, 1e-9);
  }
}

TEST(Gmds, ThreadsChangeNothing) {
  const test::KnownPair pair = test::posed_pair(1000);
  const auto matched = [&](int threads) {
    return match_gmds(pair.source_surface(), pair.target_surface(), kFewPoints,
                      test::with_threads(threads))
        .points;
  };
  EXPECT_EQ(matched(1), matched(3));
}

TEST(Gmds, RejectsWhatItCannotDo) {
  const MetricSurface small = test::metric_surface(test::icosphere(1));
  EXPECT_THROW(match_gmds(small, small), InvalidInput);
  GmdsOptions few = kFewPoints;
  few.max_target_vertices = 500;
  const test::KnownPair pair = test::relabelled_pair(1000);
  EXPECT_THROW(match_gmds(pair.source_surface(), pair.target_surface(), few), InvalidInput);
  EXPECT_THROW((GmdsOptions{.points = 4}.validate()), InvalidInput);
  EXPECT_THROW((GmdsOptions{.start_candidates = 4}.validate()), InvalidInput);
  EXPECT_THROW((GmdsOptions{.tolerance = 0}.validate()), InvalidInput);
}

TEST(CoarseAssignments, AreTheBestOfAll) {
  const Eigen::MatrixXd points = Eigen::MatrixXd::Random(7, 2);
  Eigen::MatrixXd given(7, 7);
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 7; ++j) given(i, j) = (points.row(i) - points.row(j)).norm();
  const std::vector<int> hidden{4, 1, 6, 3};
  const Eigen::MatrixXd wanted = given(hidden, hidden);
  EXPECT_EQ(coarse_assignments(wanted, 4, given, 1000, 1).front(), hidden);
}

TEST(Stress, MovingAPointNeverRaisesIt) {
  const MetricSurface shape = test::metric_surface(test::rough_sphere(3, 0.1, 1));
  const DistanceTable distances(shape, {});
  const Eigen::MatrixXd wanted = Eigen::MatrixXd::Constant(6, 6, 0.4);
  const Stress stress(shape, distances, wanted);
  SurfaceMap points;
  for (int i = 0; i < 6; ++i) points.push_back(stress.at_vertex(40 * i));
  double last = stress.total(points);
  for (int i = 0; i < 60; ++i) {
    stress.improve(points, i % 6);
    const double now = stress.total(points);
    EXPECT_LE(now, last * (1 + 1e-9));
    last = now;
  }
}

TEST(Stress, BestVertexIsThatOfBruteForce) {
  const MetricSurface shape = test::metric_surface(test::rough_sphere(2, 0.1, 1));
  const DistanceTable distances(shape, {});
  Eigen::MatrixXd wanted(4, 4);
  wanted << 0, .1, .2, .3, .1, 0, .4, .5, .2, .4, 0, .6, .3, .5, .6, 0;
  const Stress stress(shape, distances, wanted);
  SurfaceMap points;
  for (int vertex : {5, 50, 100, 150}) points.push_back(stress.at_vertex(vertex));
  points[3] = stress.best_vertex(points, 3);
  const double least = stress.total(points);
  for (int vertex = 0; vertex < shape.num_vertices(); ++vertex) {
    points[3] = stress.at_vertex(vertex);
    EXPECT_GE(stress.total(points), least - 1e-9);
  }
}

}  // namespace
}  // namespace isomatch::baselines
