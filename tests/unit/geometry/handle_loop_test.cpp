// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/handle_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <vector>

#include "support/shapes.h"

namespace isomatch {
namespace {

using test::box;
using test::torus;

constexpr double kMajor = 2, kMinor = 0.5;

std::vector<double> ones(const Mesh& mesh) {
  return std::vector<double>(mesh.vertices.size(), 1.0);
}

int num_handles(const Mesh& mesh) { return HandleLoops(mesh, ones(mesh)).num_handles(); }

Mesh joined(Mesh a, const Mesh& b) {
  const int offset = a.num_vertices();
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (Face face : b.faces) {
    for (int& v : face) v += offset;
    a.faces.push_back(face);
  }
  return a;
}

Mesh without_vertices(Mesh mesh, const std::vector<int>& removed) {
  std::erase_if(mesh.faces, [&](const Face& face) {
    return std::ranges::any_of(face, [&](int v) { return std::ranges::count(removed, v) > 0; });
  });
  return mesh;
}

TEST(HandleLoops, AreCounted) {
  EXPECT_EQ(num_handles(box(4)), 0);
  EXPECT_EQ(num_handles(torus(24, 12)), 1);
  EXPECT_EQ(num_handles(joined(torus(24, 12), torus(30, 10))), 2);
  EXPECT_EQ(num_handles(joined(torus(24, 12), box(3))), 1);
  EXPECT_EQ(num_handles(test::open_cylinder(12, 5)), 0);
}

TEST(HandleLoops, HolesAreNoHandles) {
  EXPECT_EQ(num_handles(without_vertices(box(6), {30, 100})), 0);
  EXPECT_EQ(num_handles(without_vertices(torus(24, 12), {0, 140})), 1);
}

TEST(HandleLoops, MeshesWithFinsHaveNone) {
  Mesh mesh = torus(24, 12);
  mesh.vertices.emplace_back(5, 5, 5);
  mesh.faces.push_back({mesh.faces[0][0], mesh.faces[0][1], mesh.num_vertices() - 1});
  EXPECT_EQ(num_handles(mesh), 0);
}

/// The edges of a loop are edges of the mesh, and no vertex is there twice.
void expect_loop_of_edges(const Mesh& mesh, const std::vector<int>& loop) {
  std::set<std::pair<int, int>> edges;
  for (const Face& face : mesh.faces)
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(face[k], face[(k + 1) % 3]));
  for (std::size_t i = 0; i < loop.size(); ++i)
    EXPECT_TRUE(edges.contains(std::minmax(loop[i], loop[(i + 1) % loop.size()])));
  EXPECT_EQ(std::set<int>(loop.begin(), loop.end()).size(), loop.size());
}

TEST(HandleLoops, TheCheapestGoesAroundTheTube) {
  const Mesh mesh = torus(60, 24, kMajor, kMinor);
  const HandleLoops loops(mesh, ones(mesh));
  for (const int root : {0, 17, 333}) {
    const HandleLoops::Loop loop = loops.cheapest(std::vector<int>{root});
    EXPECT_NEAR(loop.cost, 2 * std::numbers::pi * kMinor, 0.05);
    expect_loop_of_edges(mesh, loop.vertices);
    EXPECT_EQ(num_handles(without_vertices(mesh, loop.vertices)), 0);
  }
}

TEST(HandleLoops, WeightsSayWhereTheCheapestGoes) {
  const Mesh mesh = torus(60, 24, kMajor, kMinor);
  std::vector<double> weights = ones(mesh);
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (mesh.vertices[v].head<2>().norm() < kMajor - 0.99 * kMinor) weights[v] = 0.01;
  const HandleLoops::Loop loop = HandleLoops(mesh, weights).cheapest(std::vector<int>{5});
  EXPECT_NEAR(loop.cost, 0.01 * 2 * std::numbers::pi * (kMajor - kMinor), 0.01);
  for (const int v : loop.vertices) EXPECT_EQ(weights[v], 0.01);
}

TEST(HandleLoops, ThereIsNoLoopWithoutAHandle) {
  const Mesh mesh = box(4);
  EXPECT_TRUE(HandleLoops(mesh, ones(mesh)).cheapest(std::vector<int>{0, 7}).vertices.empty());
}

}  // namespace
}  // namespace isomatch
