// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "isomatch/carry/pose_transfer.h"
#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "support/maps.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"

namespace isomatch {
namespace {

using testing::Each;

void expect_near(const std::vector<Point>& actual, const std::vector<Point>& expected,
                 double tolerance) {
  ASSERT_EQ(actual.size(), expected.size());
  double worst = 0;
  for (std::size_t v = 0; v < actual.size(); ++v)
    worst = std::max(worst, (actual[v] - expected[v]).norm());
  EXPECT_LT(worst, tolerance);
}

/// A cylinder whose upper part bends.
std::vector<Point> bent(const Mesh& mesh) {
  std::vector<Point> result;
  for (const Point& p : mesh.vertices) {
    const double angle = 0.8 * std::max(0.0, p.z() - 1);
    result.push_back(Eigen::AngleAxisd(angle, Point::UnitX()) * p);
  }
  return result;
}

std::vector<Point> transformed(const Eigen::Affine3d& motion, const std::vector<Point>& points) {
  std::vector<Point> result;
  for (const Point& p : points) result.push_back(motion * p);
  return result;
}

TEST(PoseTransfer, ACopyOfTheSourceFollowsExactly) {
  const Mesh mesh = test::closed_cylinder(12, 8);
  const PoseTransfer carry(mesh, mesh, test::identity_map(mesh));
  EXPECT_THAT(carry.followers(), Each(false));
  expect_near(carry(mesh.vertices), mesh.vertices, 1e-9);
  expect_near(carry(bent(mesh)), bent(mesh), 1e-9);
}

TEST(PoseTransfer, RigidAndScaledPosesAreExact) {
  const Mesh mesh = test::rough_sphere(2, 0.2, 1);
  const PoseTransfer carry(mesh, mesh, test::identity_map(mesh));
  test::Random random(2);
  Eigen::Affine3d motion(random.rotation());
  motion.pretranslate(Point(3, -4, 5));
  expect_near(carry(transformed(motion, mesh.vertices)), transformed(motion, mesh.vertices), 1e-9);
  const auto larger = test::scaled(mesh, 3).vertices;
  expect_near(carry(larger), larger, 1e-9);
}

/// The target is the source turned and larger: it takes the frame's pose, in its own size.
TEST(PoseTransfer, TheTargetTakesThePoseWhereverItStood) {
  const Mesh source = test::closed_cylinder(12, 8);
  test::Random random(3);
  const Mesh target = test::moved(test::scaled(source, 2), random);
  const PoseTransfer carry(source, target, test::identity_map(source));
  Mesh frame = source;
  frame.vertices = bent(source);
  expect_near(carry(frame.vertices), test::scaled(frame, 2).vertices, 1e-8);
}

TEST(PoseTransfer, InTheSameRestPoseItKeepsHowItStands) {
  const Mesh source = test::closed_cylinder(12, 8);
  const Eigen::Affine3d turn(Eigen::AngleAxisd(0.3, Point::UnitY()));
  Mesh target = source;
  target.vertices = transformed(turn, source.vertices);
  for (Point& p : target.vertices) p = 2 * p + Point(5, -3, 1);
  const PoseTransfer carry(source, target, test::identity_map(source), {.same_rest_pose = true});
  EXPECT_EQ(carry(source.vertices), target.vertices);
  Mesh moved = source;
  for (Point& p : moved.vertices) p += Point(0, 1, 0);
  Mesh expected = target;
  for (Point& p : expected.vertices) p += Point(0, 2, 0);
  expect_near(carry(moved.vertices), expected.vertices, 1e-9);
}

TEST(PoseTransfer, TheNeutralFrameIsTheTargetItself) {
  // Of another shape, with a part that is not matched and a face without area.
  const Mesh source = test::icosphere(2);
  Mesh target = source;
  for (Point& p : target.vertices) p = p.cwiseProduct(Point(1, 2, 0.5)) + Point(7, 0, 0);
  target = test::combined(target, test::scaled(test::icosphere(1), 0.1));
  target.vertices.insert(target.vertices.end(), {Point(8, 1, 0), Point(9, 2, 0), Point(10, 3, 0)});
  const int last = target.num_vertices() - 1;
  target.faces.push_back({last - 2, last - 1, last});
  SurfaceMap map = test::identity_map(source);
  map[3] = {};
  map.resize(target.vertices.size());
  const PoseTransfer carry(source, target, map, {.same_rest_pose = true});
  expect_near(carry(source.vertices), target.vertices, 1e-12);
}

TEST(PoseTransfer, SplitVerticesStayTogether) {
  const Mesh source = test::icosphere(2);
  const Mesh target = test::split_charts(source, test::octants(source));
  SurfaceMap map = test::identity_map(source);
  for (int v = source.num_vertices(); v < target.num_vertices(); ++v) {
    const auto twin = std::ranges::find(source.vertices, target.vertices[v]);
    map.push_back(map[twin - source.vertices.begin()]);
  }
  const std::vector<Point> pose = PoseTransfer(source, target, map)(bent(source));
  for (int v = source.num_vertices(); v < target.num_vertices(); ++v) {
    const auto twin = std::ranges::find(source.vertices, target.vertices[v]);
    EXPECT_EQ(pose[v], pose[twin - source.vertices.begin()]);
  }
}

TEST(PoseTransfer, WhatIsUnmatchedFollows) {
  const Mesh sphere = test::icosphere(2);
  const Mesh both = test::combined(sphere, test::scaled(test::icosphere(1), 0.1));
  SurfaceMap map = test::identity_map(sphere);
  map[0] = {};
  map.resize(both.vertices.size());
  const PoseTransfer carry(sphere, both, map);
  EXPECT_TRUE(carry.followers()[0]);
  EXPECT_FALSE(carry.followers()[1]);
  EXPECT_TRUE(carry.followers().back());
  test::Random random(5);
  Eigen::Affine3d motion(random.rotation());
  motion.pretranslate(Point(1, 2, 3));
  // The place of the whole is that of its matched part: a hair off where a vertex is missing.
  expect_near(carry(transformed(motion, sphere.vertices)), transformed(motion, both.vertices),
              1e-9);
}

TEST(PoseTransfer, BadInputThrows) {
  const Mesh mesh = test::icosphere(1);
  const SurfaceMap map = test::identity_map(mesh);
  EXPECT_THROW(PoseTransfer(mesh, mesh, SurfaceMap(3)), InvalidInput);
  EXPECT_THROW(PoseTransfer(mesh, mesh, SurfaceMap(mesh.vertices.size())), InvalidInput);
  const PoseTransfer carry(mesh, mesh, map);
  std::vector<Point> frame = mesh.vertices;
  frame[2].x() = std::nan("");
  EXPECT_THROW(carry(frame), InvalidInput);
  frame.pop_back();
  EXPECT_THROW(carry(frame), InvalidInput);
}

}  // namespace
}  // namespace isomatch
