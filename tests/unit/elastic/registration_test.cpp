// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/registration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "shape/boundary.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "unit/tracked/prepared.h"

namespace isomatch::elastic {
namespace {

using test::Prepared;

Projection onto(const Prepared& target) {
  const tracked::Proxy& proxy = target.proxy;
  return {proxy.mesh, proxy.faces, proxy.normals, proxy.features, {}};
}

/// A cloud of nodes and its deformation.
struct Cloud {
  explicit Cloud(const Prepared& source)
      : graph(tracked::node_graph(source.proxy, 200)),
        deformation(graph.cloud.positions, graph.neighbours) {}

  Registration register_onto(const Prepared& target, const std::vector<Point>& anchors) {
    return elastic::register_onto(graph.cloud, deformation, onto(target), anchors, {}, {}, {});
  }

  tracked::NodeGraph graph;
  Deformation deformation;
};

/// Where the target has the vertices that the nodes of `source` stand at, for two meshes that
/// differ in their coordinates alone.
std::vector<Point> images(const Cloud& cloud, const Prepared& source, const Prepared& target) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < cloud.graph.cloud.positions.size(); ++i) {
    const int vertex = source.proxy.detail_vertex[source.proxy.nodes[i]];
    const int input = source.surface.input_vertex[vertex];
    points.push_back(target.surface.mesh.vertices[target.surface.surface_vertex[input]]);
  }
  return points;
}

double mean_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).norm();
  return sum / static_cast<double>(a.size());
}

class RegistrationTest : public testing::Test {
 protected:
  const Mesh mesh_ = synthesize({.vertices = 1000, .pose = 1}).mesh;
  const Prepared source_{mesh_};
};

TEST_F(RegistrationTest, OntoItselfChangesNothing) {
  Cloud cloud(source_);
  const std::vector<Point> rest = cloud.graph.cloud.positions;
  const Registration registration = cloud.register_onto(source_, rest);
  EXPECT_LT(registration.energy, 1e-6);
  EXPECT_LT(registration.distance, 1e-4);
  EXPECT_LT(registration.deviation, 1e-3);
  EXPECT_LT(mean_distance(cloud.deformation.positions(), rest), 1e-3);
  ASSERT_EQ(registration.feet.size(), rest.size());
}

TEST_F(RegistrationTest, FollowsARigidMotion) {
  test::Random random(1);
  const Prepared target(test::scaled(test::moved(mesh_, random), 5));
  Cloud cloud(source_);
  const std::vector<Point> moved = images(cloud, source_, target);
  const Registration registration = cloud.register_onto(target, moved);
  EXPECT_LT(registration.energy, 1e-5);
  EXPECT_LT(registration.distance, 1e-3);
  EXPECT_LT(mean_distance(cloud.deformation.positions(), moved), 2e-3);
}

TEST_F(RegistrationTest, RepairsAnchorsThatAreALittleWrong) {
  test::Random random(2);
  Cloud cloud(source_);
  const std::vector<Point> rest = cloud.graph.cloud.positions;
  std::vector<Point> anchors = rest;
  for (Point& p : anchors) p += 0.05 * random.direction();
  const Registration registration = cloud.register_onto(source_, anchors);
  EXPECT_LT(mean_distance(cloud.deformation.positions(), rest), 0.02);
  EXPECT_LT(registration.distance, 0.005);
}

TEST_F(RegistrationTest, MirroredAnchorsCostMoreEnergy) {
  const Prepared rest(synthesize({.vertices = 1000, .pose = 0}).mesh);
  Cloud right(rest), mirrored(rest);
  std::vector<Point> anchors = right.graph.cloud.positions;
  const double energy = right.register_onto(rest, anchors).energy;
  for (Point& p : anchors) p.x() = -p.x();
  EXPECT_GT(mirrored.register_onto(rest, anchors).energy, energy + 1e-3);
}

/// What is beyond a plane has no counterpart.
std::vector<bool> inside_above(const Cloud& cloud, double least) {
  std::vector<bool> inside;
  for (const Point& p : cloud.graph.cloud.positions) inside.push_back(p.z() > least);
  return inside;
}

TEST_F(RegistrationTest, PointsOutsideFollowARigidMotionOfTheRestAndDoNotPull) {
  test::Random random(3);
  const Prepared target(test::moved(mesh_, random));
  Cloud cloud(source_);
  const std::vector<Point> moved = images(cloud, source_, target);
  cloud.graph.cloud.inside = inside_above(cloud, 0);
  std::vector<Point> anchors = moved;
  for (std::size_t i = 0; i < anchors.size(); ++i)
    if (!cloud.graph.cloud.inside[i]) anchors[i] += 0.1 * random.direction();
  const Registration registration = cloud.register_onto(target, anchors);
  EXPECT_LT(registration.energy, 1e-4);
  EXPECT_LT(mean_distance(cloud.deformation.positions(), moved), 0.01);
}

TEST_F(RegistrationTest, PointsOutsideMayStandAnywhereAtFirst) {
  Cloud cloud(source_);
  const std::vector<Point> rest = cloud.graph.cloud.positions;
  cloud.graph.cloud.inside = inside_above(cloud, 0);
  std::vector<Point> inside_rest, inside_now;
  std::vector<Point> anchors = rest;
  for (std::size_t i = 0; i < anchors.size(); ++i)
    if (!cloud.graph.cloud.inside[i]) anchors[i] += Point(0, 2, 0);
  cloud.register_onto(source_, anchors);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (!cloud.graph.cloud.inside[i]) continue;
    inside_rest.push_back(rest[i]);
    inside_now.push_back(cloud.deformation.positions()[i]);
  }
  EXPECT_LT(mean_distance(inside_rest, inside_now), 0.05);
}

TEST_F(RegistrationTest, DistanceIsThatOfPointsInside) {
  Cloud all(source_), none(source_);
  std::vector<Point> anchors = all.graph.cloud.positions;
  for (Point& p : anchors) p += Point(0.5, 0, 0);
  const RegistrationOptions nothing{.anchor_steps = 0, .surface_steps = 0};
  none.graph.cloud.inside.assign(anchors.size(), false);
  const auto result = [&](Cloud& cloud) {
    return register_onto(cloud.graph.cloud, cloud.deformation, onto(source_), anchors, nothing, {},
                         {});
  };
  EXPECT_GT(result(all).distance, 0.1);
  EXPECT_EQ(result(none).distance, 0);
  EXPECT_EQ(result(none).deviation, 0);
}

/// A sheet of [0, 2] x [0, 1] above its left half, in one unit of length.
class SheetAboveItsHalf : public testing::Test {
 protected:
  Registration result(bool with_rim, double reach) {
    const Mesh half = test::sheet(20, 20);
    const IndexLists faces = vertex_faces(half);
    const std::vector<Point> normals(half.vertices.size(), Point::UnitZ());
    const std::vector<Features> features(half.vertices.size());
    const std::vector<int> rim = with_rim ? boundary_vertices(half) : std::vector<int>();
    const Projection surface(half, faces, normals, features, {}, rim);
    Deformation deformation(cloud_.positions, graph_.neighbours);
    return register_onto(cloud_, deformation, surface, cloud_.positions,
                         {.anchor_steps = 0, .surface_steps = 0, .reach = reach}, {}, {});
  }

  void SetUp() override {
    for (Point& p : cloud_.positions) p = p * source_.surface.scale + source_.surface.centre;
    cloud_.features.assign(cloud_.positions.size(), {});
    cloud_.normals.assign(cloud_.positions.size(), Point::UnitZ());
    cloud_.inside.assign(cloud_.positions.size(), true);
  }

  const Prepared source_{test::sheet(40, 20, 2, 1)};
  tracked::NodeGraph graph_ = tracked::node_graph(source_.proxy, 300);
  PointCloud& cloud_ = graph_.cloud;
};

TEST_F(SheetAboveItsHalf, FeetOnTheRimAreNotMet) {
  const Registration registration = result(true, 10);
  int met = 0;
  for (std::size_t i = 0; i < cloud_.positions.size(); ++i) {
    const Point& p = cloud_.positions[i];
    const bool within = p.x() > 0.01 && p.x() < 0.99 && p.y() > 0.01 && p.y() < 0.99;
    EXPECT_EQ(registration.met[i], within) << p.transpose();
    EXPECT_EQ(registration.feet[i].on_rim, !within) << p.transpose();
    met += within ? 1 : 0;
  }
  EXPECT_GT(met, 50);
}

TEST_F(SheetAboveItsHalf, WithoutARimAllThatIsWithinReachIsMet) {
  const Registration far = result(false, 10), near = result(false, 0.32);
  for (std::size_t i = 0; i < cloud_.positions.size(); ++i) {
    EXPECT_TRUE(far.met[i]);
    EXPECT_EQ(near.met[i], cloud_.positions[i].x() < 1.32);
  }
}

TEST_F(SheetAboveItsHalf, WhereNothingIsMissingReachDoesNotCount) {
  cloud_.inside.clear();
  const Registration registration = result(true, 0.01);
  EXPECT_EQ(std::ranges::count(registration.met, true), std::ssize(cloud_.positions));
}

}  // namespace
}  // namespace isomatch::elastic
