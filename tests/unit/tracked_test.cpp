// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/tracked.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/map_io.h"
#include "isomatch/mesh_io.h"
#include "isomatch/metrics.h"
#include "isomatch/synth.h"
#include "support/context.h"
#include "support/mesh_files.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

/// That every vertex of a surface has a point on the other one.
void expect_whole(const SurfaceMap& map, const Shape& from, const Shape& onto) {
  ASSERT_EQ(map.size(), from.num_vertices());
  for (const SurfacePoint& point : map) {
    ASSERT_GE(point.face, 0);
    ASSERT_LT(point.face, onto.surface.mesh.num_faces());
    double sum = 0;
    for (double weight : point.weights) {
      EXPECT_GE(weight, 0);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1, 1e-9);
  }
}

/// That the relation has every vertex of both surfaces, in order and without repetition.
void expect_covering(const Correspondence& relation, const Shape& source, const Shape& target) {
  std::set<int> sources, targets;
  for (const Match& match : relation) {
    sources.insert(match.source);
    targets.insert(match.target);
  }
  EXPECT_EQ(std::ssize(sources), source.num_vertices());
  EXPECT_EQ(std::ssize(targets), target.num_vertices());
  EXPECT_TRUE(std::ranges::is_sorted(relation));
  EXPECT_EQ(std::ranges::adjacent_find(relation), relation.end());
}

/// That the result keeps its promises, however good the map is.
// NOLINTNEXTLINE(readability-function-size): one expectation after the other.
void expect_sound(const TrackedResult& result, const Shape& source, const Shape& target) {
  ASSERT_FALSE(result.maps.empty());
  for (const TrackedMap& map : result.maps) {
    expect_whole(map.source_to_target, source, target);
    expect_whole(map.target_to_source, target, source);
    expect_covering(matches(source, target, map), source, target);
    ASSERT_EQ(map.registered.size(), source.num_vertices());
    for (const Point& p : map.registered) EXPECT_TRUE(p.allFinite());
    for (const double figure : {map.energy, map.distance, map.deviation, map.distortion}) {
      EXPECT_GE(figure, -1e-12);  // 1 - cosine rounds.
      EXPECT_TRUE(std::isfinite(figure));
    }
  }
  EXPECT_GE(result.confidence, 0);
  EXPECT_LE(result.confidence, 1);
  EXPECT_FALSE(result.times.empty());
  EXPECT_FALSE(result.hypotheses.empty());
}

std::vector<Point> places(const Shape& target, const SurfaceMap& map) {
  std::vector<Point> points;
  for (const SurfacePoint& point : map) points.push_back(position(target.surface.mesh, point));
  return points;
}

double mean_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).norm();
  return sum / static_cast<double>(a.size());
}

/// Where the vertices of the input of `from` go, all of which must be part of its surface.
std::vector<Point> input_places(const Shape& from, const Shape& onto, const SurfaceMap& map) {
  const std::vector<Point> points = places(onto, map);
  std::vector<Point> result;
  for (int vertex : from.surface.surface_vertex) result.push_back(points[vertex]);
  return result;
}

/// Two meshes, and the vertices of template points on both, in numbers of the input.
struct TruePair {
  Mesh source, target;
  std::vector<int> source_truth, target_truth, mirrored_target_truth;
};

TruePair creatures(int vertices, std::uint64_t seed) {
  SynthShape source = synthesize({.vertices = vertices, .pose = 1, .seed = seed});
  SynthShape target = synthesize({.vertices = vertices, .pose = 2, .seed = seed});
  return {std::move(source.mesh), std::move(target.mesh), source.ground_truth, target.ground_truth,
          target.symmetric_ground_truth};
}

/// Mean errors of the best map to points on triangles, over sqrt(area).
struct Errors {
  double direct, mirrored;
};

Errors errors(const TruePair& pair, const Shape& source, const Shape& target,
              const TrackedResult& result) {
  const auto against = [&](const std::vector<int>& truth) {
    return point_errors(target,
                        surface_truth(source.surface, target.surface, pair.source_truth, truth),
                        result.maps.front().source_to_target)
        .mean;
  };
  return {against(pair.target_truth), against(pair.mirrored_target_truth)};
}

/// Matches a pair, checks the result and measures its errors.
Errors matched_errors(const TruePair& pair) {
  const Shape source = prepare_shape(pair.source), target = prepare_shape(pair.target);
  const TrackedResult result = match_tracked(source, target);
  expect_sound(result, source, target);
  EXPECT_TRUE(result.oriented);
  return errors(pair, source, target, result);
}

TrackedOptions with_alternatives(int count) {
  TrackedOptions options;
  options.alternatives = count;
  return options;
}

class TrackedCreatures : public testing::TestWithParam<std::uint64_t> {};

TEST_P(TrackedCreatures, AreMatchedWithoutAFlip) {
  const Errors errors = matched_errors(creatures(1500, GetParam()));
  // The truth is off by up to half an edge, which is .028, on either side.
  EXPECT_LT(errors.direct, 0.035);
  EXPECT_LT(errors.direct, 0.3 * errors.mirrored);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TrackedCreatures, testing::Values(1, 2, 3, 4));

/// A pair of creatures, matched once for all tests, under the changes that must not matter.
class TrackedPair : public testing::Test {
 protected:
  static void SetUpTestSuite() { plain_.emplace(creatures(1000, 2)); }
  static void TearDownTestSuite() { plain_.reset(); }

  struct Plain {
    explicit Plain(TruePair creatures)
        : pair(std::move(creatures)),
          source(prepare_shape(pair.source)),
          target(prepare_shape(pair.target)),
          result(match_tracked(source, target)) {}

    TruePair pair;
    Shape source, target;
    TrackedResult result;
  };

  /// That the changed pair is matched as well as the plain one.
  void expect_as_plain(const TruePair& changed) const {
    EXPECT_NEAR(matched_errors(changed).direct,
                errors(pair_, source_, target_, plain_->result).direct, 0.002);
  }

  static std::optional<Plain> plain_;
  const TruePair& pair_ = plain_->pair;
  const Shape& source_ = plain_->source;
  const Shape& target_ = plain_->target;
  const TrackedMap& map_ = plain_->result.maps.front();
};

std::optional<TrackedPair::Plain> TrackedPair::plain_;

TEST_F(TrackedPair, ThreadsChangeNothing) {
  const auto matched = [&](int threads) {
    const Context context = test::with_threads(threads);
    return match_tracked(prepare_shape(pair_.source, {}, context),
                         prepare_shape(pair_.target, {}, context), with_alternatives(1), context);
  };
  const TrackedResult one = matched(1), three = matched(3);
  ASSERT_EQ(one.maps.size(), three.maps.size());
  for (std::size_t k = 0; k < one.maps.size(); ++k) {
    const TrackedMap &a = one.maps[k], &b = three.maps[k];
    EXPECT_EQ(a.source_to_target, b.source_to_target);
    EXPECT_EQ(a.target_to_source, b.target_to_source);
    EXPECT_EQ(a.registered, b.registered);
    EXPECT_EQ(a.energy, b.energy);
    EXPECT_EQ(a.distance, b.distance);
    EXPECT_EQ(a.deviation, b.deviation);
    EXPECT_EQ(a.distortion, b.distortion);
    EXPECT_EQ(a.orientation, b.orientation);
  }
  EXPECT_EQ(one.confidence, three.confidence);
  EXPECT_TRUE(
      std::ranges::equal(one.hypotheses, three.hypotheses, [](const auto& a, const auto& b) {
        return a.distortion == b.distortion && a.orientation == b.orientation &&
               a.coarse_energy == b.coarse_energy;
      }));
}

TEST_F(TrackedPair, ScaleAndPositionDoNotMatter) {
  test::Random random(1);
  TruePair moved = pair_;
  moved.source = test::scaled(test::moved(pair_.source, random), 7);
  moved.target = test::scaled(test::moved(pair_.target, random), 0.01);
  expect_as_plain(moved);
}

TEST_F(TrackedPair, NumbersDoNotMatter) {
  test::Random random(1);
  const test::Relabelled source = test::relabelled(pair_.source, random);
  const test::Relabelled target = test::relabelled(pair_.target, random);
  TruePair relabelled{source.mesh, target.mesh, pair_.source_truth, pair_.target_truth,
                      pair_.mirrored_target_truth};
  for (int& v : relabelled.source_truth) v = source.new_vertex[v];
  for (int& v : relabelled.target_truth) v = target.new_vertex[v];
  for (int& v : relabelled.mirrored_target_truth) v = target.new_vertex[v];
  expect_as_plain(relabelled);
}

TEST_F(TrackedPair, MirrorImagesOfBothAreMatchedAsThey) {
  TruePair mirrored = pair_;
  mirrored.source = test::mirrored(pair_.source);
  mirrored.target = test::mirrored(pair_.target);
  expect_as_plain(mirrored);
}

TEST_F(TrackedPair, MirrorImageIsMatchedLeftToRight) {
  TruePair mirrored = pair_;
  mirrored.target = test::mirrored(pair_.target);
  const Errors errors = matched_errors(mirrored);
  EXPECT_LT(errors.mirrored, 0.03);
  EXPECT_LT(errors.mirrored, 0.3 * errors.direct);
}

TEST_F(TrackedPair, FacesTurnedOverDoNotMatter) {
  const auto turned = [](Mesh mesh) {
    for (Face& face : mesh.faces) std::swap(face[1], face[2]);
    return mesh;
  };
  const Shape source = prepare_shape(turned(pair_.source));
  const Shape target = prepare_shape(turned(pair_.target));
  for (const auto& [from, onto] :
       {std::pair{&source_, &target}, {&source, &target_}, {&source, &target}}) {
    const TrackedResult result = match_tracked(*from, *onto);
    expect_sound(result, *from, *onto);
    const TrackedMap& map = result.maps.front();
    EXPECT_LT(mean_distance(input_places(*from, *onto, map.source_to_target),
                            input_places(source_, target_, map_.source_to_target)),
              1e-3);
    EXPECT_LT(mean_distance(input_places(*onto, *from, map.target_to_source),
                            input_places(target_, source_, map_.target_to_source)),
              1e-3);
  }
}

TEST_F(TrackedPair, RegisteredSourceLiesOnItsPoints) {
  const double size = std::sqrt(target_.surface.area);
  EXPECT_LT(mean_distance(map_.registered, places(target_, map_.source_to_target)), 0.01 * size);
}

TEST_F(TrackedPair, AlternativesAreOtherMaps) {
  ASSERT_EQ(plain_->result.maps.size(), 1);
  const TrackedResult result = match_tracked(source_, target_, with_alternatives(3));
  expect_sound(result, source_, target_);
  ASSERT_GE(result.maps.size(), 2);
  ASSERT_LE(result.maps.size(), 4);
  EXPECT_EQ(result.maps.front().source_to_target, map_.source_to_target);
  const std::vector<Point> first = places(target_, map_.source_to_target);
  for (std::size_t k = 1; k < result.maps.size(); ++k) {
    const std::vector<Point> other = places(target_, result.maps[k].source_to_target);
    EXPECT_GT(mean_distance(first, other), 0.03 * std::sqrt(target_.surface.area));
  }
}

TEST_F(TrackedPair, MirrorImageIsFoundIfReflectionIsAllowed) {
  TrackedOptions options;
  options.allow_reflection = true;
  // Nothing is nearer to the mirror image of a bent shape than what it is the image of.
  const Shape image = prepare_shape(test::mirrored(pair_.source));
  const TrackedResult result = match_tracked(source_, image, options);
  expect_sound(result, source_, image);
  EXPECT_TRUE(result.maps.front().mirrored);
  const std::vector<Point> points =
      input_places(source_, image, result.maps.front().source_to_target);
  EXPECT_LT(mean_distance(points, test::mirrored(pair_.source).vertices), 1e-3);
  EXPECT_FALSE(match_tracked(source_, target_, options).maps.front().mirrored);
}

TEST_F(TrackedPair, LandmarksAreMatchedExactly) {
  const auto vertex = [](const Shape& shape, int input) {
    return shape.surface.surface_vertex[input];
  };
  TrackedOptions options;
  for (const int point : {100, 1500, 4000})
    options.landmarks.push_back(
        {vertex(source_, pair_.source_truth[point]), vertex(target_, pair_.target_truth[point])});
  const TrackedResult result = match_tracked(source_, target_, options);
  expect_sound(result, source_, target_);
  EXPECT_LT(errors(pair_, source_, target_, result).direct, 0.025);
  const TrackedMap& map = result.maps.front();
  for (const auto& [s, t] : options.landmarks) {
    const Point& goal = target_.surface.mesh.vertices[t];
    EXPECT_LT((position(target_.surface.mesh, map.source_to_target[s]) - goal).norm(), 1e-12);
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

TEST_F(TrackedPair, PartsOfTheMethodMayBeLeftOut) {
  for (bool TrackedOptions::*part : {&TrackedOptions::orientation, &TrackedOptions::elastic_judging,
                                     &TrackedOptions::refinement}) {
    TrackedOptions options;
    options.*part = false;
    expect_sound(match_tracked(source_, target_, options), source_, target_);
  }
}

TEST_F(TrackedPair, SmallComponentsAreLeftOut) {
  TruePair pair = pair_;
  pair.source = test::combined(pair_.source, test::scaled(test::tetrahedron(), 0.01));
  const Mesh part = test::scaled(test::icosphere(1), 0.1);
  pair.target = test::combined(part, pair_.target);
  for (int& v : pair.target_truth) v += part.num_vertices();
  for (int& v : pair.mirrored_target_truth) v += part.num_vertices();
  expect_as_plain(pair);
}

TEST_F(TrackedPair, SaysWhenASurfaceHasNoOutside) {
  Mesh turned = pair_.source;
  test::Random random(1);
  for (Face& face : turned.faces)
    if (random.uniform() < 0.5) std::swap(face[0], face[1]);
  const Shape source = prepare_shape(turned);
  const TrackedResult result = match_tracked(source, target_);
  EXPECT_FALSE(result.oriented);
  expect_sound(result, source, target_);
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
  const TruePair pair{mesh, test::moved(copy.mesh, random), all, copy.new_vertex, copy.new_vertex};
  EXPECT_LT(matched_errors(pair).direct, 0.003);
}

/// That a map or `InvalidInput` comes out, and nothing else.
void expect_map_or_refusal(const Mesh& a, const Mesh& b) {
  const Shape source = prepare_shape(a), target = prepare_shape(b);
  try {
    expect_sound(match_tracked(source, target), source, target);
  } catch (const InvalidInput&) {
  }
}

TEST(Tracked, IsNotConfidentOfAShapeThatTurnsIntoItself) {
  const Shape sphere = prepare_shape(test::icosphere(2));
  const TrackedResult result = match_tracked(sphere, sphere);
  expect_sound(result, sphere, sphere);
  EXPECT_LT(result.confidence, 0.1);
}

TEST(Tracked, MatchesOrRefusesTinyMeshes) {
  const Mesh triangle{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  const std::vector<Mesh> meshes{triangle,     test::tetrahedron(), test::sheet(1, 1),
                                 test::box(1), test::icosphere(0),  test::icosphere(1)};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (std::size_t j = 0; j < meshes.size(); ++j) {
      SCOPED_TRACE(std::to_string(i) + " onto " + std::to_string(j));
      expect_map_or_refusal(meshes[i], meshes[j]);
    }
  }
}

class TrackedZoo : public testing::TestWithParam<test::ZooMesh> {};

TEST_P(TrackedZoo, IsMatchedOrRefused) {
  expect_map_or_refusal(GetParam().mesh, test::icosphere(1));
  expect_map_or_refusal(test::torus(12, 6), GetParam().mesh);
}

INSTANTIATE_TEST_SUITE_P(Meshes, TrackedZoo, testing::ValuesIn(test::mesh_zoo()),
                         [](const auto& test) { return test.param.name; });

TEST(Tracked, StopsWhenAsked) {
  const Shape sphere = prepare_shape(test::icosphere(2));
  std::stop_source stop;
  stop.request_stop();
  Context context;
  context.stop = stop.get_token();
  EXPECT_THROW(match_tracked(sphere, sphere, {}, context), Cancelled);
}

TEST(TrackedOptions, OutOfRangeAreRejected) {
  EXPECT_NO_THROW(TrackedOptions{}.validate());
  const Shape sphere = prepare_shape(test::icosphere(1));
  const TrackedOptions options = with_alternatives(-1);
  EXPECT_THROW(options.validate(), InvalidInput);
  EXPECT_THROW(match_tracked(sphere, sphere, options), InvalidInput);
}

struct RealPair {
  std::string name, folder, source, target;
};

class TrackedData : public testing::TestWithParam<RealPair> {};

TEST_P(TrackedData, IsMatchedWithoutAFlip) {
  const std::string folder = ISOMATCH_TEST_DATA "/" + GetParam().folder + "/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  TruePair pair{read_mesh(folder + GetParam().source + ".off"),
                read_mesh(folder + GetParam().target + ".off"),
                {},
                {},
                {}};
  const auto truth = [&](const std::string& name, const Mesh& mesh) {
    return read_vts(folder + "corres/" + name, mesh.num_vertices());
  };
  pair.source_truth = truth(GetParam().source + ".vts", pair.source);
  pair.target_truth = truth(GetParam().target + ".vts", pair.target);
  pair.mirrored_target_truth = truth(GetParam().target + ".sym.vts", pair.target);
  const Errors errors = matched_errors(pair);
  EXPECT_LT(errors.direct, 0.035);
  EXPECT_LT(errors.direct, errors.mirrored);
}

INSTANTIATE_TEST_SUITE_P(Shapes, TrackedData,
                         testing::Values(RealPair{"People", "faust5k", "tr_reg_001", "tr_reg_023"},
                                         RealPair{"Horses", "tosca5k", "horse0", "horse6"}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace isomatch
