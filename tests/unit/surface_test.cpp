// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "isomatch/error.h"
#include "isomatch/topology.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

/// Number of edges by their number of faces: [1] boundary, [2] inner, [3] all others.
std::array<int, 4> edges_by_faces(const Mesh& mesh) {
  std::array<int, 4> counts{};
  for_each_edge(sorted_edge_sides(mesh), [&](std::span<const EdgeSide> sides) {
    ++counts[std::min<std::size_t>(sides.size(), 3)];
  });
  return counts;
}

bool is_closed_manifold_by_edges(const Mesh& mesh) {
  const auto edges = edges_by_faces(mesh);
  return edges[1] == 0 && edges[3] == 0;
}

TEST(Surface, TextureSeamOfASphereCloses) {
  const Surface surface = extract_surface(test::uv_sphere(16, 8));
  EXPECT_EQ(surface.num_vertices(), 16 * 7 + 2);
  EXPECT_EQ(surface.mesh.num_faces(), 16 * 6 * 2 + 2 * 16);
  EXPECT_TRUE(is_closed_manifold_by_edges(surface.mesh));
}

TEST(Surface, ChartsBecomeOneSphereAgain) {
  const Surface surface = extract_surface(test::sphere_of_charts());
  EXPECT_EQ(surface.num_vertices(), 162);
  EXPECT_EQ(surface.mesh.num_faces(), 320);
  EXPECT_TRUE(is_closed_manifold_by_edges(surface.mesh));
}

TEST(Surface, LooseTrianglesBecomeOneSphere) {
  const Surface surface = extract_surface(test::soup(test::icosphere(2)));
  EXPECT_EQ(surface.num_vertices(), 162);
  EXPECT_EQ(surface.joined_edges, 480);
  EXPECT_TRUE(is_closed_manifold_by_edges(surface.mesh));
}

}  // namespace
}  // namespace isomatch
