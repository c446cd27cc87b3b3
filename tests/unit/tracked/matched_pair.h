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

/// That it lies on a face of the surface.
inline void expect_point(const SurfacePoint& point, const Shape& shape) {
  ASSERT_GE(point.face, 0);
  ASSERT_LT(point.face, shape.mesh().num_faces());
  for (int v : shape.mesh().faces[point.face]) EXPECT_TRUE(shape.on_surface(v));
  double sum = 0;
  for (double weight : point.weights) {
    EXPECT_GE(weight, 0);
    sum += weight;
  }
  EXPECT_NEAR(sum, 1, 1e-9);
}

/// That every vertex of a surface has a point on the other one, and copies at a seam the same.
/// Those of other components may have one.
inline void expect_whole(const SurfaceMap& map, const Shape& from, const Shape& onto) {
  ASSERT_EQ(std::ssize(map), from.num_vertices());
  for (int v = 0; v < from.num_vertices(); ++v) {
    if (from.on_surface(v)) {
      expect_point(map[v], onto);
      EXPECT_EQ(map[v], map[from.copies(v).front()]);
    } else if (map[v] != SurfacePoint{}) {
      expect_point(map[v], onto);
    }
  }
}

inline std::set<int> vertices_on_surface(const Shape& shape) {
  std::set<int> vertices;
  for (int v = 0; v < shape.num_vertices(); ++v)
    if (shape.on_surface(v)) vertices.insert(v);
  return vertices;
}

/// That the relation has every vertex of both surfaces, in order and without repetition.
inline void expect_covering(const Correspondence& relation, const Shape& source,
                            const Shape& target) {
  std::set<int> sources, targets;
  for (const Match& match : relation) {
    sources.insert(match.source);
    targets.insert(match.target);
  }
  EXPECT_EQ(sources, vertices_on_surface(source));
  EXPECT_EQ(targets, vertices_on_surface(target));
  EXPECT_TRUE(std::ranges::is_sorted(relation));
  EXPECT_EQ(std::ranges::adjacent_find(relation), relation.end());
}

inline void expect_sound_figures(const TrackedMap& map, const Shape& source) {
  ASSERT_EQ(std::ssize(map.registered), source.num_vertices());
  for (const Point& p : map.registered) EXPECT_TRUE(p.allFinite());
  for (const double figure : {map.energy, map.distance, map.deviation, map.distortion}) {
    EXPECT_GE(figure, -1e-12);  // 1 - cosine rounds.
    EXPECT_TRUE(std::isfinite(figure));
  }
}

/// That the result keeps its promises, however good the map is.
// NOLINTNEXTLINE(readability-function-size): one expectation after the other.
inline void expect_sound(const TrackedResult& result, const Shape& source, const Shape& target) {
  ASSERT_FALSE(result.maps.empty());
  for (const TrackedMap& map : result.maps) {
    expect_whole(map.source_to_target, source, target);
    expect_whole(map.target_to_source, target, source);
    expect_covering(matches(source, target, map), source, target);
    expect_sound_figures(map, source);
  }
  EXPECT_GE(result.ambiguity, 0);
  EXPECT_LE(result.ambiguity, 1);
  EXPECT_FALSE(result.times.empty());
  EXPECT_FALSE(result.hypotheses.empty());
}

/// That what has a point has it on the other surface.
inline void expect_partial(const SurfaceMap& map, const Shape& from, const Shape& onto) {
  ASSERT_EQ(std::ssize(map), from.num_vertices());
  for (int v = 0; v < from.num_vertices(); ++v) {
    if (map[v] == SurfacePoint{}) continue;
    expect_point(map[v], onto);
  }
}

/// What holds of shapes as well of which something may be missing: vertices may have no point.
inline void expect_sound_parts(const TrackedResult& result, const Shape& source,
                               const Shape& target) {
  ASSERT_FALSE(result.maps.empty());
  for (const TrackedMap& map : result.maps) {
    expect_partial(map.source_to_target, source, target);
    expect_partial(map.target_to_source, target, source);
    for (const Match& match : matches(source, target, map)) {
      EXPECT_TRUE(source.on_surface(match.source));
      EXPECT_TRUE(target.on_surface(match.target));
    }
    expect_sound_figures(map, source);
  }
  EXPECT_GE(result.ambiguity, 0);
  EXPECT_LE(result.ambiguity, 1);
  EXPECT_FALSE(result.hypotheses.empty());
}

/// Where the vertices go, all of which must have a point.
inline std::vector<Point> places(const Shape& target, const SurfaceMap& map) {
  std::vector<Point> points;
  for (const SurfacePoint& point : map) points.push_back(position(target.mesh(), point));
  return points;
}

inline double mean_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).norm();
  return sum / static_cast<double>(a.size());
}

/// Two meshes, and the vertices of template points on both.
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
    return point_errors(source, target, {pair.source_truth, truth},
                        result.maps.front().source_to_target)
        .mean;
  };
  return {against(pair.target_truth), against(pair.mirrored_target_truth)};
}

/// Matches a pair, checks the result and measures its errors.
inline Errors matched_errors(const TruePair& pair) {
  const Shape source(pair.source), target(pair.target);
  const TrackedResult result = match_tracked(source, target);
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
          source(pair.source),
          target(pair.target),
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

  inline static std::optional<Plain> plain_;
  const TruePair& pair_ = plain_->pair;
  const Shape& source_ = plain_->source;
  const Shape& target_ = plain_->target;
  const TrackedMap& map_ = plain_->result.maps.front();
};

}  // namespace isomatch::test
