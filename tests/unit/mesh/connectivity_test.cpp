// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "isomatch/mesh/topology.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

void expect_closed(const Mesh& mesh, int genus) {
  const Connectivity closed_manifold{.vertices = mesh.num_vertices(),
                                     .edges = 3 * mesh.num_faces() / 2,
                                     .faces = mesh.num_faces(),
                                     .components = 1};
  EXPECT_EQ(connectivity(mesh), closed_manifold);
  EXPECT_EQ(closed_manifold.euler_characteristic(), 2 - 2 * genus);
  EXPECT_EQ(connectivity(mesh).genus(), genus);
}

/// Edges that two faces traverse in the same direction.
int inconsistent_edges_by_map(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (const Face& face : mesh.faces) {
    for (int corner = 0; corner < 3; ++corner) ++uses[{face[corner], face[(corner + 1) % 3]}];
  }
  int count = 0;
  for (const auto& [edge, number] : uses) count += number == 2;
  return count;
}

TEST(Connectivity, ClosedShapesHaveTheirGenus) {
  expect_closed(test::icosphere(0), 0);
  expect_closed(test::icosphere(3), 0);
  expect_closed(test::box(1), 0);
  expect_closed(test::box(5), 0);
  expect_closed(test::closed_cylinder(7, 3), 0);
  expect_closed(test::torus(9, 5), 1);
}

TEST(Connectivity, SheetHasOneBorder) {
  const Connectivity counts = connectivity(test::sheet(6, 4));
  EXPECT_EQ(counts.edges, 6 * 5 + 4 * 7 + 6 * 4);
  EXPECT_EQ(counts.boundary_edges, 2 * (6 + 4));
  EXPECT_EQ(counts.boundary_loops, 1);
  EXPECT_EQ(counts.euler_characteristic(), 1);
  EXPECT_EQ(counts.genus(), 0);
}

TEST(Connectivity, OpenCylinderHasTwoBorders) {
  const Connectivity counts = connectivity(test::open_cylinder(9, 4));
  EXPECT_EQ(counts.boundary_edges, 2 * 9);
  EXPECT_EQ(counts.boundary_loops, 2);
  EXPECT_EQ(counts.euler_characteristic(), 0);
  EXPECT_EQ(counts.genus(), 0);
}

TEST(Connectivity, HolesLeaveTheGenus) {
  Mesh mesh = test::torus(12, 8);
  mesh.faces.erase(mesh.faces.begin() + 100);
  mesh.faces.erase(mesh.faces.begin());
  const Connectivity counts = connectivity(mesh);
  EXPECT_EQ(counts.boundary_loops, 2);
  EXPECT_EQ(counts.euler_characteristic(), -2);
  EXPECT_EQ(counts.genus(), 1);
}

TEST(Connectivity, HolesThatMeetInAVertexHaveOneBorder) {
  // Of the fan of six faces around a vertex, two that are not neighbours are missing.
  Mesh mesh = test::sheet(4, 4);
  const IndexLists around = vertex_faces(mesh);
  const int middle = 12;
  ASSERT_EQ(around[middle].size(), 6u);
  const std::vector<int> faces(around[middle].begin(), around[middle].end());
  const auto neighbours = face_neighbours(mesh);
  const int first = faces[0];
  const auto second = std::ranges::find_if(
      faces, [&](int f) { return f != first && std::ranges::count(neighbours[first], f) == 0; });
  ASSERT_NE(second, faces.end());
  mesh.faces.erase(mesh.faces.begin() + *second);
  mesh.faces.erase(mesh.faces.begin() + first);
  const Connectivity counts = connectivity(mesh);
  EXPECT_EQ(counts.boundary_edges, 16 + 6);
  EXPECT_EQ(counts.boundary_loops, 1 + 1);
  EXPECT_EQ(counts.nonmanifold_vertices, 1);
}

TEST(Connectivity, MoebiusStripIsNotOrientable) {
  const Connectivity counts = connectivity(test::moebius_strip(11));
  EXPECT_FALSE(counts.orientable);
  EXPECT_EQ(counts.boundary_loops, 1);
  EXPECT_EQ(counts.boundary_edges, 2 * 11);
  EXPECT_EQ(counts.euler_characteristic(), 0);
  EXPECT_EQ(counts.genus(), std::nullopt);
}

TEST(Connectivity, FlippedFacesStayOrientable) {
  const Mesh mesh = test::sphere_with_flipped_faces();
  const Connectivity counts = connectivity(mesh);
  EXPECT_EQ(counts.inconsistent_edges, inconsistent_edges_by_map(mesh));
  EXPECT_GT(counts.inconsistent_edges, 32);
  EXPECT_TRUE(counts.orientable);
  EXPECT_EQ(counts.genus(), 0);
}

TEST(Connectivity, FinMakesANonManifoldEdge) {
  const Connectivity counts = connectivity(test::sphere_with_fin());
  EXPECT_EQ(counts.nonmanifold_edges, 1);
  EXPECT_EQ(counts.nonmanifold_vertices, 0);
  EXPECT_EQ(counts.boundary_edges, 2);
  EXPECT_EQ(counts.boundary_loops, 1);
  EXPECT_EQ(counts.genus(), std::nullopt);
}

TEST(Connectivity, BowTieHasANonManifoldVertex) {
  const Connectivity counts = connectivity(test::bow_tie());
  EXPECT_EQ(counts.nonmanifold_vertices, 1);
  EXPECT_EQ(counts.nonmanifold_edges, 0);
  EXPECT_EQ(counts.components, 1);
  EXPECT_EQ(counts.euler_characteristic(), 2 + 2 - 1);
  EXPECT_EQ(counts.genus(), std::nullopt);
}

TEST(Connectivity, ComponentsAddUp) {
  const Connectivity counts = connectivity(test::three_spheres());
  EXPECT_EQ(counts.components, 3);
  EXPECT_EQ(counts.euler_characteristic(), 6);
  EXPECT_EQ(counts.genus(), std::nullopt);
}

TEST(Connectivity, IgnoresLooseVerticesAndFacesWithARepeatedVertex) {
  Mesh mesh = test::sphere_with_unreferenced_vertices();
  mesh.faces.push_back({0, 0, 1});
  mesh.faces.push_back({2, 3, 2});
  const Connectivity counts = connectivity(mesh);
  EXPECT_EQ(counts.vertices, 162);
  EXPECT_EQ(counts.faces, 320);
  EXPECT_EQ(counts.components, 1);
  EXPECT_EQ(counts.genus(), 0);
}

class ConnectivityZoo : public ::testing::TestWithParam<test::ZooMesh> {};
INSTANTIATE_TEST_SUITE_P(All, ConnectivityZoo, ::testing::ValuesIn(test::mesh_zoo()));

TEST_P(ConnectivityZoo, DoesNotDependOnLabels) {
  test::Random random(5);
  const Connectivity a = connectivity(GetParam().mesh);
  const Connectivity b = connectivity(test::relabelled(GetParam().mesh, random).mesh);
  EXPECT_EQ(a, b);
}

}  // namespace
}  // namespace isomatch
