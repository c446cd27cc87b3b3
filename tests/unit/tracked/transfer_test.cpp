// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/transfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isomatch/synth.h"
#include "support/mesh_files.h"
#include "support/random.h"
#include "support/shapes.h"
#include "unit/tracked/prepared.h"

namespace isomatch::tracked {
namespace {

using test::Prepared;

constexpr ProxyOptions kSmall{.vertices = 500, .nodes = 150};

elastic::Deformation deformation_of(const Prepared& prepared) {
  NodeGraph graph = node_graph(prepared.proxy, prepared.proxy.num_nodes());
  return {std::move(graph.cloud.positions), std::move(graph.neighbours)};
}

DeformedSurface transferred(const Prepared& prepared, const elastic::Deformation& deformation) {
  return transfer(prepared.shape, prepared.surface, prepared.proxy, deformation,
                  node_graph(prepared.proxy, deformation.size()).cloud.features);
}

TEST(Transfer, CarriesARigidMotionExactly) {
  const Prepared prepared(synthesize({.vertices = 2000, .pose = 1}).mesh, kSmall);
  test::Random random(1);
  for (int trial = 0; trial < 3; ++trial) {
    const Eigen::Matrix3d rotation = random.rotation();
    const Point shift = random.direction();
    elastic::Deformation deformation = deformation_of(prepared);
    std::vector<Point> moved = deformation.rest();
    for (Point& p : moved) p = rotation * p + shift;
    deformation.set_positions(moved);
    for (int i = 0; i < 50; ++i) deformation.fit_rotations(0);
    const DeformedSurface result = transferred(prepared, deformation);
    ASSERT_EQ(result.positions.size(), prepared.shape.num_vertices());
    for (int v = 0; v < prepared.shape.num_vertices(); ++v) {
      const Point expected = rotation * prepared.surface.mesh.vertices[v] + shift;
      EXPECT_LT((result.positions[v] - expected).norm(), 1e-5);
      EXPECT_LT((result.normals[v] - rotation * prepared.surface.normals[v]).norm(), 1e-4);
    }
  }
}

TEST(Transfer, OfTheRestPoseChangesNothing) {
  const Prepared prepared(test::torus(60, 30), kSmall);
  const DeformedSurface result = transferred(prepared, deformation_of(prepared));
  ASSERT_EQ(result.features.size(), prepared.shape.num_vertices());
  for (int v = 0; v < prepared.shape.num_vertices(); ++v) {
    EXPECT_LT((result.positions[v] - prepared.surface.mesh.vertices[v]).norm(), 1e-12);
    EXPECT_LT((result.normals[v] - prepared.surface.normals[v]).norm(), 1e-12);
  }
}

TEST(Transfer, FollowsASmoothBend) {
  const Prepared prepared(test::sheet(40, 40), kSmall);
  const auto rolled = [](const Point& p) {
    return Point(std::sin(p.x()), p.y(), 1 - std::cos(p.x()));
  };
  elastic::Deformation deformation = deformation_of(prepared);
  std::vector<Point> positions = deformation.rest();
  for (Point& p : positions) p = rolled(p);
  deformation.set_positions(positions);
  for (int i = 0; i < 50; ++i) deformation.fit_rotations(0);
  const DeformedSurface result = transferred(prepared, deformation);
  for (int v = 0; v < prepared.shape.num_vertices(); ++v)
    EXPECT_LT((result.positions[v] - rolled(prepared.surface.mesh.vertices[v])).norm(), 0.01);
}

TEST(Transfer, OfTinyMeshes) {
  const Mesh triangle{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  for (const Mesh& mesh : {triangle, test::tetrahedron()}) {
    const Prepared prepared(mesh);
    const DeformedSurface result = transferred(prepared, deformation_of(prepared));
    for (int v = 0; v < prepared.shape.num_vertices(); ++v)
      EXPECT_LT((result.positions[v] - prepared.surface.mesh.vertices[v]).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace isomatch::tracked
