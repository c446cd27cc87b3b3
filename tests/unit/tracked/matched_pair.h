// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "isomatch/measure/metrics.h"
#include "isomatch/mesh/synth.h"
#include "isomatch/methods/tracked.h"

namespace isomatch::test {

/// That every vertex of a surface has a point on the other one.
inline void expect_whole(const SurfaceMap& map, const Shape& from, const Shape& onto) {
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
inline void expect_covering(const Correspondence& relation, const Shape& source,
                            const Shape& target) {
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
inline void expect_sound(const TrackedResult& result, const Shape& source, const Shape& target) {
  ASSERT_FALSE(result.maps.empty());
  for (const TrackedMap& map : result.maps) {
    expect_whole(map.source_to_target, source, target);
    expect_whole(map.target_to_source, target, source);
    expect_covering(matches(source.surface, target.surface, map), source, target);
    ASSERT_EQ(map.registered.size(), source.num_vertices());
    for (const Point& p : map.registered) EXPECT_TRUE(p.allFinite());
    for (const double figure : {map.energy, map.distance, map.deviation, map.distortion}) {
      EXPECT_GE(figure, -1e-12);  // 1 - cosine rounds.
      EXPECT_TRUE(std::isfinite(figure));
    }
  }
  EXPECT_GE(result.ambiguity, 0);
  EXPECT_LE(result.ambiguity, 1);
  EXPECT_FALSE(result.times.empty());
  EXPECT_FALSE(result.hypotheses.empty());
}

inline std::vector<Point> places(const Shape& target, const SurfaceMap& map) {
  std::vector<Point> points;
  for (const SurfacePoint& point : map) points.push_back(position(target.surface.mesh, point));
  return points;
}

inline double mean_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).norm();
  return sum / static_cast<double>(a.size());
}

/// Where the vertices of the input of `from` go, all of which must be part of its surface.
inline std::vector<Point> input_places(const Shape& from, const Shape& onto,
                                       const SurfaceMap& map) {
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

inline TruePair creatures(int vertices, std::uint64_t seed) {
  SynthShape source = synthesize({.vertices = vertices, .pose = 1, .seed = seed});
  SynthShape target = synthesize({.vertices = vertices, .pose = 2, .seed = seed});
  return {std::move(source.mesh), std::move(target.mesh), source.ground_truth, target.ground_truth,
          target.symmetric_ground_truth};
}

/// Mean errors of the best map to points on triangles, over sqrt(area).
struct Errors {
  double direct, mirrored;
};

inline Errors errors(const TruePair& pair, const Shape& source, const Shape& target,
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
inline Errors matched_errors(const TruePair& pair) {
  const Shape source = prepare_shape(pair.source), target = prepare_shape(pair.target);
  const TrackedResult result = match_tracked(source.surface, target.surface);
  expect_sound(result, source, target);
  EXPECT_TRUE(result.oriented);
  return errors(pair, source, target, result);
}

inline TrackedOptions with_alternatives(int count) {
  TrackedOptions options;
  options.alternatives = count;
  return options;
}

/// A pair of creatures, matched once for all tests, under the changes that must not matter.
class CreaturePair : public testing::Test {
 protected:
  static void SetUpTestSuite() { plain_.emplace(creatures(1000, 2)); }
  static void TearDownTestSuite() { plain_.reset(); }

  struct Plain {
    explicit Plain(TruePair creatures)
        : pair(std::move(creatures)),
          source(prepare_shape(pair.source)),
          target(prepare_shape(pair.target)),
          result(match_tracked(source.surface, target.surface)) {}

    TruePair pair;
    Shape source, target;
    TrackedResult result;
  };

  /// That the changed pair is matched as well as the plain one.
  void expect_as_plain(const TruePair& changed) const {
    EXPECT_NEAR(matched_errors(changed).direct,
                errors(pair_, source_, target_, plain_->result).direct, 0.002);
  }

  inline static std::optional<Plain> plain_;
  const TruePair& pair_ = plain_->pair;
  const Shape& source_ = plain_->source;
  const Shape& target_ = plain_->target;
  const TrackedMap& map_ = plain_->result.maps.front();
};

}  // namespace isomatch::test
