// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/deformed_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "support/mesh_files.h"
#include "support/random.h"
#include "support/shapes.h"
#include "tracked/shape/pyramid.h"

namespace isomatch::tracked {
namespace {

/// With a detail of a part of the vertices.
Pyramid small_pyramid(const Mesh& mesh) {
  const PyramidOptions options{.detail_vertices = 800, .proxy = {.vertices = 500, .nodes = 150}};
  return make_pyramid(PreparedShape(mesh, {}), {}, options, {});
}

elastic::Deformation deformation_of(const Pyramid& pyramid) {
  NodeGraph graph = node_graph(pyramid.proxy, pyramid.proxy.num_nodes());
  return {std::move(graph.cloud.positions), std::move(graph.neighbours)};
}

DeformedSurface carried(const Pyramid& pyramid, const elastic::Deformation& deformation) {
  return deformed_surface(pyramid, deformation, node_graph(pyramid.proxy, deformation.size()).cloud,
                          {});
}

TEST(DeformedSurface, CarriesARigidMotionExactly) {
  const Pyramid pyramid = small_pyramid(synthesize({.vertices = 2000, .pose = 1}).mesh);
  test::Random random(1);
  for (int trial = 0; trial < 3; ++trial) {
    const Eigen::Matrix3d rotation = random.rotation();
    const Point shift = random.direction();
    elastic::Deformation deformation = deformation_of(pyramid);
    std::vector<Point> moved = deformation.rest();
    for (Point& p : moved) p = rotation * p + shift;
    deformation.set_positions(moved);
    for (int i = 0; i < 50; ++i) deformation.fit_rotations(0, {});
    const DeformedSurface result = carried(pyramid, deformation);
    ASSERT_EQ(result.positions.size(), pyramid.surface->mesh.num_vertices());
    for (int v = 0; v < pyramid.surface->mesh.num_vertices(); ++v) {
      const Point expected = rotation * pyramid.surface->mesh.vertices[v] + shift;
      EXPECT_LT((result.positions[v] - expected).norm(), 1e-5);
      EXPECT_LT((result.normals[v] - rotation * pyramid.surface->normals[v]).norm(), 1e-4);
    }
  }
}

TEST(DeformedSurface, OfAProxyIsThatOfItsVertices) {
  const Pyramid pyramid = small_pyramid(synthesize({.vertices = 2000, .pose = 1}).mesh);
  elastic::Deformation deformation = deformation_of(pyramid);
  std::vector<Point> bent = deformation.rest();
  for (Point& p : bent) p = Point(p.x() + 0.3 * p.y() * p.y(), p.y(), p.z());
  deformation.set_positions(bent);
  for (int i = 0; i < 20; ++i) deformation.fit_rotations(0, {});
  const auto nodes = node_graph(pyramid.proxy, deformation.size()).cloud;
  const DeformedSurface result = deformed_surface(pyramid.proxy, deformation, nodes);
  ASSERT_EQ(result.positions.size(), pyramid.proxy.num_vertices());
  ASSERT_EQ(result.features.size(), pyramid.proxy.num_vertices());
  double sum = 0;
  for (int v = 0; v < pyramid.proxy.num_vertices(); ++v) {
    const Point& p = pyramid.proxy.mesh.vertices[v];
    sum += (result.positions[v] - Point(p.x() + 0.3 * p.y() * p.y(), p.y(), p.z())).norm();
    EXPECT_NEAR(result.normals[v].norm(), 1, 1e-9);
  }
  EXPECT_LT(sum / pyramid.proxy.num_vertices(), 0.01);
}

TEST(DeformedSurface, OfTheRestPoseChangesNothing) {
  const Pyramid pyramid = small_pyramid(test::torus(60, 30));
  const DeformedSurface result = carried(pyramid, deformation_of(pyramid));
  ASSERT_EQ(result.features.size(), pyramid.detail.mesh.num_vertices());
  for (int v = 0; v < pyramid.surface->mesh.num_vertices(); ++v) {
    EXPECT_LT((result.positions[v] - pyramid.surface->mesh.vertices[v]).norm(), 1e-12);
    EXPECT_LT((result.normals[v] - pyramid.surface->normals[v]).norm(), 1e-12);
  }
}

TEST(DeformedSurface, FollowsASmoothBend) {
  const Pyramid pyramid = small_pyramid(test::sheet(40, 40));
  const auto rolled = [](const Point& p) {
    return Point(std::sin(p.x()), p.y(), 1 - std::cos(p.x()));
  };
  elastic::Deformation deformation = deformation_of(pyramid);
  std::vector<Point> positions = deformation.rest();
  for (Point& p : positions) p = rolled(p);
  deformation.set_positions(positions);
  for (int i = 0; i < 50; ++i) deformation.fit_rotations(0, {});
  const DeformedSurface result = carried(pyramid, deformation);
  for (int v = 0; v < pyramid.surface->mesh.num_vertices(); ++v)
    EXPECT_LT((result.positions[v] - rolled(pyramid.surface->mesh.vertices[v])).norm(), 0.01);
}

TEST(DeformedSurface, OfTinyMeshes) {
  const Mesh triangle{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  for (const Mesh& mesh : {triangle, test::tetrahedron()}) {
    const Pyramid pyramid = small_pyramid(mesh);
    const DeformedSurface result = carried(pyramid, deformation_of(pyramid));
    for (int v = 0; v < pyramid.surface->mesh.num_vertices(); ++v)
      EXPECT_LT((result.positions[v] - pyramid.surface->mesh.vertices[v]).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace isomatch::tracked
