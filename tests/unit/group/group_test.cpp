// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/group/group.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/interpolation.h"
#include "isomatch/error.h"
#include "isomatch/mesh/synth.h"
#include "support/context.h"

namespace isomatch {
namespace {

using test::with_threads;

/// Poses of one creature, of which it is known where each vertex lies at rest.
struct Poses {
  std::vector<SynthShape> made;
  std::vector<Shape> shapes;

  explicit Poses(int count, double cut_of_last = 0) {
    for (int pose = 1; pose <= count; ++pose) {
      SynthOptions options;
      options.vertices = 1000;
      options.pose = pose;
      options.seed = 3;
      if (pose == count) options.cut = cut_of_last;
      made.push_back(synthesize(options));
      shapes.emplace_back(made.back().mesh);
    }
  }

  /// Mean distance at rest between the vertices of `source` and the points they are mapped to, over
  /// sqrt(area) of the target.
  double error(const SurfaceMap& map, int source, int target) const {
    double sum = 0;
    int count = 0;
    for (std::size_t v = 0; v < map.size(); ++v) {
      if (map[v].face < 0) continue;
      sum += (interpolated(made[target].mesh, made[target].rest, map[v]) - made[source].rest[v])
                 .norm();
      ++count;
    }
    return sum / count / std::sqrt(shapes[target].area());
  }
};

/// Four poses, matched once for all tests.
class MatchedGroup : public testing::Test {
 protected:
  static const Poses& poses() {
    static const Poses made(4);
    return made;
  }

  static const GroupResult& group() {
    static const GroupResult matched = match_group(poses().shapes, {}, with_threads(2));
    return matched;
  }
};

TEST_F(MatchedGroup, PointsLieWhereTheyBelong) {
  ASSERT_EQ(group().members.size(), 4);
  const int from = group().template_shape;
  for (int k = 0; k < 4; ++k) {
    const GroupMember& member = group().members[k];
    EXPECT_LT(poses().error(member.from_template, from, k), 0.02);
    EXPECT_LT(poses().error(member.to_template, k, from), 0.02);
    EXPECT_EQ(member.fit.grade, FitGrade::kGood);
    EXPECT_EQ(member.registered.size(), member.from_template.size());
  }
}

TEST_F(MatchedGroup, PairsAgree) {
  EXPECT_EQ(group().pairs.size(), 6);
  for (const GroupPair& pair : group().pairs) {
    EXPECT_EQ(pair.use, PairUse::kAgrees);
    EXPECT_LT(pair.cycle_error, 0.02);
  }
}

TEST_F(MatchedGroup, MapsBetweenMembersCloseCycles) {
  const SurfaceMap there = member_map(poses().shapes, group(), 1, 2),
                   back = member_map(poses().shapes, group(), 2, 1);
  EXPECT_LT(poses().error(there, 1, 2), 0.02);
  const Mesh& mesh = poses().shapes[1].mesh();
  std::vector<Point> ends;
  for (const SurfacePoint& point : back) ends.push_back(position(mesh, point));
  int closed = 0;
  for (std::size_t v = 0; v < there.size(); ++v) {
    const Point end = interpolated(poses().shapes[2].mesh(), ends, there[v]);
    closed += (end - mesh.vertices[v]).norm() < 0.02 * std::sqrt(poses().shapes[1].area());
  }
  EXPECT_GE(closed, 0.99 * static_cast<double>(there.size()));
}

TEST_F(MatchedGroup, IsTheSameForAnyThreadsAndLittleMemory) {
  GroupOptions little;
  little.memory = 0;
  const GroupResult again = match_group(poses().shapes, little, with_threads(1));
  EXPECT_EQ(group().template_shape, again.template_shape);
  for (std::size_t k = 0; k < again.members.size(); ++k) {
    EXPECT_EQ(group().members[k].from_template, again.members[k].from_template);
    EXPECT_EQ(group().members[k].to_template, again.members[k].to_template);
    EXPECT_EQ(group().members[k].spread, again.members[k].spread);
  }
}

TEST(Group, APartHasWhatItHas) {
  const Poses poses(3, 0.4);
  const GroupResult group = match_group(poses.shapes, {}, with_threads(2));
  EXPECT_NE(group.template_shape, 2);
  int missing = 0;
  for (const SurfacePoint& point : group.members[2].from_template) missing += point.face < 0;
  EXPECT_NEAR(missing / static_cast<double>(group.members[2].from_template.size()), 0.4, 0.15);
  EXPECT_LT(poses.error(group.members[2].from_template, group.template_shape, 2), 0.04);
  for (const int whole : {0, 1})
    for (const SurfacePoint& point : group.members[whole].from_template) EXPECT_GE(point.face, 0);
}

TEST(Group, TakesTheTemplateThatIsGiven) {
  const Poses poses(3);
  GroupOptions options;
  options.template_shape = 2;
  options.neighbours = 0;
  const GroupResult group = match_group(poses.shapes, options, with_threads(2));
  EXPECT_EQ(group.template_shape, 2);
  EXPECT_EQ(group.pairs.size(), 2);
}

TEST(Group, RefusesWhatCannotBe) {
  const Poses poses(2);
  GroupOptions options;
  EXPECT_THROW(match_group(std::span(poses.shapes).first(1), options), InvalidInput);
  options.template_shape = 2;
  EXPECT_THROW(match_group(poses.shapes, options), InvalidInput);
  options.template_shape = -1;
  options.matching.landmarks = {{0, 0}};
  EXPECT_THROW(match_group(poses.shapes, options), InvalidInput);
}

}  // namespace
}  // namespace isomatch
