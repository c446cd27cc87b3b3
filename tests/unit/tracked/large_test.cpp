// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// Meshes of which the method works on simplified copies: of more than 5,000 vertices for what is
// global, of more than 40,000 for the rest.

#include <gtest/gtest.h>

#include <cmath>

#include "support/context.h"
#include "unit/tracked/matched_pair.h"

namespace isomatch {
namespace {

/// Two poses of a creature.
struct Poses {
  explicit Poses(int vertices)
      : source(synthesize({.vertices = vertices, .pose = 1, .seed = 2})),
        target(synthesize({.vertices = vertices, .pose = 2, .seed = 2})),
        source_shape(source.mesh),
        target_shape(target.mesh) {}

  /// Mean distance, over the vertices of the source, between their places at rest and those of
  /// where they go, over sqrt(area).
  double mean_error(const SurfaceMap& source_to_target) const {
    double sum = 0;
    for (std::size_t v = 0; v < source_to_target.size(); ++v) {
      const SurfacePoint& point = source_to_target[v];
      Point rest(0, 0, 0);
      for (int k = 0; k < 3; ++k)
        rest += point.weights[k] * target.rest[target.mesh.faces[point.face][k]];
      sum += (rest - source.rest[v]).norm();
    }
    return sum / static_cast<double>(source_to_target.size()) / std::sqrt(target_shape.area());
  }

  TrackedResult matched(int threads = 0) const {
    return match_tracked(source_shape, target_shape, {}, test::with_threads(threads));
  }

  SynthShape source, target;
  Shape source_shape, target_shape;
};

/// Both are right. Edges are .012 sqrt(area) long of 8,000 vertices, .005 of 45,000; measured
/// errors are .0051 and .0064.
void expect_right(const Poses& poses, const TrackedResult& result) {
  test::expect_sound(result, poses.source_shape, poses.target_shape);
  EXPECT_LT(poses.mean_error(result.maps.front().source_to_target), 0.01);
}

TEST(TrackedLarge, IsRightAboveTheVerticesOfAProxyForAnyNumberOfThreads) {
  const Poses poses(8000);
  const TrackedResult one = poses.matched(1);
  expect_right(poses, one);
  // Made anew, so that nothing of the first match is kept.
  const TrackedResult three = Poses(8000).matched(3);
  ASSERT_EQ(three.maps.size(), 1);
  EXPECT_EQ(three.maps.front().source_to_target, one.maps.front().source_to_target);
  EXPECT_EQ(three.maps.front().target_to_source, one.maps.front().target_to_source);
  EXPECT_EQ(three.maps.front().registered, one.maps.front().registered);
  EXPECT_EQ(three.maps.front().energy, one.maps.front().energy);
  EXPECT_EQ(three.ambiguity, one.ambiguity);
}

TEST(TrackedLarge, IsRightAboveTheVerticesOfADetail) {
  const Poses poses(45000);
  expect_right(poses, poses.matched());
}

}  // namespace
}  // namespace isomatch
