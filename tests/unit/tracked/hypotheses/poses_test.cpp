// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/poses.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "support/mesh_files.h"
#include "support/random.h"
#include "support/shapes.h"
#include "tracked/shape/pyramid.h"
#include "unit/tracked/cut.h"

namespace isomatch::tracked {
namespace {

Pyramid pyramid(const Mesh& mesh, const View& view) {
  return make_pyramid(PreparedShape(mesh, {}), view,
                      {.detail_vertices = 1500, .proxy = {.vertices = 1500, .nodes = 400}}, {});
}

/// A shape, and what a rigid motion makes of a part of it.
class PosedShape {
 public:
  PosedShape(const Mesh& mesh, const Mesh& part, std::uint64_t seed)
      : random_(seed), source_(pyramid(mesh, {})), target_(pyramid(moved(part), view_of(part))) {}

  /// Angle and shift of the source's middle by which the best pose is off.
  struct Errors {
    double angle, shift;
  };

  Errors errors(const Pose& pose) const {
    const Eigen::AngleAxisd turn(pose.rotation.transpose() * rotation_);
    const Surface& onto = *target_.surface;
    const Point middle = rotation_ * source_.surface->centre + shift_;
    return {turn.angle(), (pose(Point(0, 0, 0)) - (middle - onto.centre) / onto.scale).norm()};
  }

  std::vector<Pose> found() const { return find_poses(source_.proxy, target_.proxy, {}); }

 private:
  Mesh moved(Mesh mesh) const {
    for (Point& p : mesh.vertices) p = rotation_ * p + shift_;
    return mesh;
  }

  View view_of(const Mesh& part) const {
    const PreparedShape shape(part, {});
    const double size = shape.surface()->scale / source_.surface->scale;
    return {.size = size, .open = size < 0.99};
  }

  test::Random random_;
  Eigen::Matrix3d rotation_ = random_.rotation();
  Point shift_ = 10 * random_.direction();
  Pyramid source_, target_;
};

void expect_found(const Mesh& mesh, const Mesh& part) {
  for (const std::uint64_t seed : {1, 2}) {
    const PosedShape posed(mesh, part, seed);
    const std::vector<Pose> poses = posed.found();
    ASSERT_FALSE(poses.empty());
    const auto [angle, shift] = posed.errors(poses.front());
    EXPECT_LT(angle, 0.05);
    EXPECT_LT(shift, 0.02);
    EXPECT_NEAR(poses.front().rotation.determinant(), 1, 1e-9);
  }
}

TEST(Poses, OfACreatureThatWasMovedAreFound) {
  const Mesh mesh = synthesize({.vertices = 1500, .pose = 1}).mesh;
  expect_found(mesh, mesh);
}

TEST(Poses, OfHalfOfACreatureAreFound) {
  const Mesh mesh = synthesize({.vertices = 1500, .pose = 1}).mesh;
  expect_found(mesh, test::cut(mesh, 2, 0.5));
}

TEST(Poses, OverlapMostFirst) {
  const Mesh mesh = synthesize({.vertices = 1500, .pose = 1}).mesh;
  const std::vector<Pose> poses = PosedShape(mesh, test::cut(mesh, 2, 0.5), 1).found();
  for (std::size_t k = 1; k < poses.size(); ++k) EXPECT_GE(poses[k - 1].overlap, poses[k].overlap);
  EXPECT_LE(std::ssize(poses), PoseOptions{}.kept);
  EXPECT_GT(poses.front().overlap, 0.3);
  EXPECT_LT(poses.front().overlap, 0.6);
}

TEST(Poses, OfTheSmallestShapesAreFinite) {
  const Mesh triangle{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  const std::vector<Mesh> meshes{triangle, test::tetrahedron(), test::sheet(1, 1),
                                 test::icosphere(1)};
  for (const Mesh& a : meshes) {
    for (const Mesh& b : meshes) {
      for (const Pose& pose : find_poses(pyramid(a, {}).proxy, pyramid(b, {}).proxy, {})) {
        EXPECT_TRUE(pose.rotation.allFinite());
        EXPECT_TRUE(pose.shift.allFinite());
      }
    }
  }
}

TEST(Poses, MoveAllPoints) {
  test::Random random(1);
  Pose pose;
  pose.rotation = random.rotation();
  pose.shift = random.direction();
  const std::vector<Point> points{{0, 0, 0}, {1, 2, 3}};
  const std::vector<Point> moved = posed(pose, points);
  ASSERT_EQ(moved.size(), 2);
  EXPECT_EQ(moved[0], pose.shift);
  EXPECT_EQ(moved[1], pose(points[1]));
}

}  // namespace
}  // namespace isomatch::tracked
