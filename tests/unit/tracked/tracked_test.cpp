// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/tracked.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <stop_token>
#include <string>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "support/context.h"
#include "support/data.h"
#include "support/mesh_files.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"
#include "unit/tracked/matched_pair.h"

namespace isomatch {
namespace {

class TrackedCreatures : public testing::TestWithParam<std::uint64_t> {};

TEST_P(TrackedCreatures, AreMatchedWithoutAFlip) {
  const test::Errors errors = test::matched_errors(test::creatures(1500, GetParam()));
  // The truth is off by up to half an edge, which is .028, on either side.
  EXPECT_LT(errors.direct, 0.035);
  EXPECT_LT(errors.direct, 0.3 * errors.mirrored);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TrackedCreatures, testing::Values(1, 2, 3, 4));

using TrackedPair = test::CreaturePair;

TEST_F(TrackedPair, RegisteredSourceLiesOnItsPoints) {
  const double size = std::sqrt(target_.area());
  EXPECT_LT(test::mean_distance(map_.registered, test::places(target_, map_.source_to_target)),
            0.01 * size);
}

TEST(Tracked, AlternativesAreOtherMaps) {
  const test::TruePair pair = test::creatures(1000, 3);
  const Shape source(pair.source), target(pair.target);
  const TrackedResult plain = match_tracked(source, target);
  ASSERT_EQ(plain.maps.size(), 1);
  const TrackedResult result = match_tracked(source, target, test::with_alternatives(3));
  test::expect_sound(result, source, target);
  ASSERT_GE(result.maps.size(), 2);
  ASSERT_LE(result.maps.size(), 4);
  const SurfaceMap& best = result.maps.front().source_to_target;
  EXPECT_EQ(best, plain.maps.front().source_to_target);
  const std::vector<Point> first = test::places(target, best);
  for (std::size_t k = 1; k < result.maps.size(); ++k) {
    const std::vector<Point> other = test::places(target, result.maps[k].source_to_target);
    EXPECT_GT(test::mean_distance(first, other), 0.03 * std::sqrt(target.area()));
  }
}

TEST_F(TrackedPair, MirrorImageIsFoundIfReflectionIsAllowed) {
  TrackedOptions options;
  options.allow_reflection = true;
  // Nothing is nearer to the mirror image of a bent shape than what it is the image of.
  const Shape image(test::mirrored(pair_.source));
  const TrackedResult result = match_tracked(source_, image, options);
  test::expect_sound(result, source_, image);
  EXPECT_TRUE(result.maps.front().mirrored);
  const std::vector<Point> points = test::places(image, result.maps.front().source_to_target);
  const double slack = 1e-3 * std::sqrt(image.area());
  EXPECT_LT(test::mean_distance(points, image.mesh().vertices), slack);
  // The inverse as well, although faces of the mirror image are turned the other way.
  const std::vector<Point> back = test::places(source_, result.maps.front().target_to_source);
  EXPECT_LT(test::mean_distance(back, source_.mesh().vertices), slack);
  EXPECT_FALSE(match_tracked(source_, target_, options).maps.front().mirrored);
}

TEST_F(TrackedPair, LandmarksAreMatchedExactly) {
  TrackedOptions options;
  for (const int point : {100, 1500, 4000})
    options.landmarks.push_back({pair_.source_truth[point], pair_.target_truth[point]});
  const TrackedResult result = match_tracked(source_, target_, options);
  test::expect_sound(result, source_, target_);
  EXPECT_LT(test::errors(pair_, source_, target_, result).direct, 0.025);
  const TrackedMap& map = result.maps.front();
  for (const auto& [s, t] : options.landmarks) {
    const Point& goal = pair_.target.vertices[t];
    EXPECT_LT((position(pair_.target, map.source_to_target[s]) - goal).norm(), 1e-12);
  }
}

TEST_F(TrackedPair, BadLandmarksAreRejected) {
  const auto expect_rejected = [&](const Correspondence& landmarks) {
    TrackedOptions options;
    options.landmarks = landmarks;
    EXPECT_THROW(match_tracked(source_, target_, options), InvalidInput);
  };
  expect_rejected({{-1, 0}});
  expect_rejected({{0, -1}});
  expect_rejected({{source_.num_vertices(), 0}});
  expect_rejected({{0, target_.num_vertices()}});
  expect_rejected({{7, 1}, {8, 2}, {7, 3}});
}

TEST(TrackedLandmarks, OfCopiesAtASeamAreThoseOfOneVertex) {
  const Mesh charts = test::sphere_of_charts();
  const Shape source(charts), target(test::icosphere(2));
  int first = 0;
  while (source.copies(first).size() < 2) ++first;
  const int copy = source.copies(first)[1];
  const auto matched = [&](const Correspondence& landmarks) {
    TrackedOptions options;
    options.landmarks = landmarks;
    return match_tracked(source, target, options);
  };
  const TrackedResult result = matched({{first, 7}, {copy, 7}});
  test::expect_sound(result, source, target);
  const SurfacePoint& point = result.maps.front().source_to_target[first];
  EXPECT_LT((position(target.mesh(), point) - target.mesh().vertices[7]).norm(), 1e-12);
  try {
    matched({{first, 7}, {copy, 8}});
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.what(), "copies of source vertex " + std::to_string(first) +
                                " on a seam have different landmarks");
  }
}

/// The template point that is farthest forward at rest, or farthest behind.
int end_of(const SynthShape& shape, bool front) {
  const auto z = [&](int v) { return shape.rest[v].z(); };
  const auto [last, first] = std::ranges::minmax_element(shape.ground_truth, {}, z);
  return front ? *first : *last;
}

TEST(TrackedLandmarks, ThatContradictTheShapesAreNamedAsTheyWereGiven) {
  const SynthShape source = synthesize({.vertices = 1000, .pose = 1, .seed = 2});
  const SynthShape target = synthesize({.vertices = 1000, .pose = 2, .seed = 2});
  // Loose triangles: every vertex has copies.
  const Shape loose(test::soup(source.mesh));
  const auto copy_of = [&](int v) {
    for (int f = 0; f < source.mesh.num_faces(); ++f)
      for (int k = 0; k < 3; ++k)
        if (source.mesh.faces[f][k] == v) return loose.copies(3 * f + k).back();
    return -1;
  };
  const Match wrong{copy_of(end_of(source, true)), end_of(target, false)};
  const int point = 700;
  const Match right{copy_of(source.ground_truth[point]), target.ground_truth[point]};
  TrackedOptions options;
  options.landmarks = {wrong, right};
  const TrackedResult result = match_tracked(loose, Shape(target.mesh), options);
  EXPECT_EQ(result.contradicted_landmarks, Correspondence{wrong});
}

TEST(TrackedLandmarks, HaveToBeOnTheSurface) {
  const Shape spheres(test::three_spheres()), sphere(test::icosphere(2));
  TrackedOptions options;
  options.landmarks = {{0, 0}};
  try {
    match_tracked(spheres, sphere, options);
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "source vertex 0 is not on the surface that is matched");
  }
  try {
    match_tracked(sphere, spheres, options);
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "target vertex 0 is not on the surface that is matched");
  }
}

TEST_F(TrackedPair, RegisteredSourceIsInTheTargetsCoordinatesWholly) {
  // A part that is not matched follows, and units and place are those of the target.
  const Mesh part = test::scaled(test::icosphere(1), 0.1);
  Mesh far = test::scaled(pair_.target, 50);
  for (Point& p : far.vertices) p += Point(1000, 0, 0);
  const Shape source(test::combined(part, pair_.source)), target(far);
  const TrackedMap map = match_tracked(source, target).maps.front();
  test::expect_whole(map.source_to_target, source, target);
  double sum = 0;
  for (int v = part.num_vertices(); v < source.num_vertices(); ++v)
    sum += (map.registered[v] - position(far, map.source_to_target[v])).norm();
  EXPECT_LT(sum / pair_.source.num_vertices(), 0.01 * std::sqrt(target.area()));
}

TEST_F(TrackedPair, PartsOfTheMethodMayBeLeftOut) {
  for (bool TrackedOptions::*part : {&TrackedOptions::orientation, &TrackedOptions::elastic_judging,
                                     &TrackedOptions::refinement}) {
    TrackedOptions options;
    options.*part = false;
    const TrackedResult result = match_tracked(source_, target_, options);
    test::expect_sound(result, source_, target_);
    EXPECT_LT(test::errors(pair_, source_, target_, result).direct, 0.06);
  }
}

TEST_F(TrackedPair, ProgressRises) {
  Context context;
  std::vector<double> fractions;
  context.progress = [&](double fraction, std::string_view) { fractions.push_back(fraction); };
  match_tracked(source_, target_, {}, context);
  ASSERT_FALSE(fractions.empty());
  EXPECT_TRUE(std::ranges::is_sorted(fractions));
  EXPECT_GE(fractions.front(), 0);
  EXPECT_LE(fractions.back(), 1);
}

TEST_F(TrackedPair, StopsOnTheWayWhenAsked) {
  std::stop_source stop;
  Context context;
  context.stop = stop.get_token();
  context.progress = [&](double fraction, std::string_view) {
    if (fraction > 0.3) stop.request_stop();
  };
  EXPECT_THROW(match_tracked(source_, target_, {}, context), Cancelled);
}

TEST(Tracked, MatchesACreatureToItself) {
  const Mesh mesh = synthesize({.vertices = 1500, .pose = 3, .seed = 5}).mesh;
  test::Random random(1);
  const test::Relabelled copy = test::relabelled(mesh, random);
  std::vector<int> all(mesh.vertices.size());
  std::iota(all.begin(), all.end(), 0);
  const test::TruePair pair{mesh, test::moved(copy.mesh, random), all, copy.new_vertex,
                            copy.new_vertex};
  EXPECT_LT(test::matched_errors(pair).direct, 0.003);
}

TEST(Tracked, StopsWhenAsked) {
  const Shape sphere(test::icosphere(2));
  std::stop_source stop;
  stop.request_stop();
  Context context;
  context.stop = stop.get_token();
  EXPECT_THROW(match_tracked(sphere, sphere, {}, context), Cancelled);
}

TEST(TrackedOptions, OutOfRangeAreRejected) {
  EXPECT_NO_THROW(TrackedOptions{}.validate());
  const Shape sphere(test::icosphere(1));
  const TrackedOptions options = test::with_alternatives(-1);
  EXPECT_THROW(options.validate(), InvalidInput);
  EXPECT_THROW(match_tracked(sphere, sphere, options), InvalidInput);
}

struct RealPair {
  std::string name, folder, source, target;
};

class TrackedData : public testing::TestWithParam<RealPair> {};

TEST_P(TrackedData, IsMatchedWithoutAFlip) {
  const std::string folder = test::data_path(GetParam().folder + "/");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  test::TruePair pair{read_mesh(folder + GetParam().source + ".off"),
                      read_mesh(folder + GetParam().target + ".off"),
                      {},
                      {},
                      {}};
  const auto truth = [&](const std::string& name, const Mesh& mesh) {
    return read_ground_truth(folder + "corres/" + name, mesh.num_vertices());
  };
  pair.source_truth = truth(GetParam().source + ".vts", pair.source);
  pair.target_truth = truth(GetParam().target + ".vts", pair.target);
  pair.mirrored_target_truth = truth(GetParam().target + ".sym.vts", pair.target);
  const test::Errors errors = test::matched_errors(pair);
  EXPECT_LT(errors.direct, 0.035);
  EXPECT_LT(errors.direct, errors.mirrored);
}

INSTANTIATE_TEST_SUITE_P(Shapes, TrackedData,
                         testing::Values(RealPair{"People", "faust5k", "tr_reg_001", "tr_reg_023"},
                                         RealPair{"Horses", "tosca5k", "horse0", "horse6"}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace isomatch
