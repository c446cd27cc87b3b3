// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/registration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "isomatch/mesh/synth.h"
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
    return elastic::register_onto(graph.cloud, deformation, onto(target), anchors, {});
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

}  // namespace
}  // namespace isomatch::elastic
