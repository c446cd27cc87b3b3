// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/topology.h"

#include <gtest/gtest.h>

namespace isomatch {
namespace {

Mesh two_triangles() {
  return {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0)}, {{0, 1, 2}, {2, 1, 3}}};
}

TEST(Topology, NeighbourStandsOppositeItsCorner) {
  const auto neighbours = face_neighbours(two_triangles());
  EXPECT_EQ(neighbours[0], (std::array{1, kNoFace, kNoFace}));
  EXPECT_EQ(neighbours[1], (std::array{kNoFace, kNoFace, 0}));
}

TEST(Topology, EdgeOfThreeFacesHasNoNeighbours) {
  Mesh mesh = two_triangles();
  mesh.vertices.emplace_back(0, 0, 1);
  mesh.faces.push_back({1, 2, 4});
  for (const auto& neighbours : face_neighbours(mesh))
    EXPECT_EQ(neighbours, (std::array{kNoFace, kNoFace, kNoFace}));
}

TEST(Topology, VertexFacesAreListedInOrder) {
  const IndexLists faces = vertex_faces(two_triangles());
  ASSERT_EQ(faces.size(), 4);
  EXPECT_EQ(std::vector<int>(faces[1].begin(), faces[1].end()), (std::vector{0, 1}));
  EXPECT_EQ(std::vector<int>(faces[3].begin(), faces[3].end()), (std::vector{1}));
}

TEST(Topology, ComponentsAreNumberedByLowestVertex) {
  Mesh mesh = two_triangles();
  mesh.vertices.insert(mesh.vertices.begin(), Point(5, 5, 5));
  for (Face& face : mesh.faces)
    for (int& v : face) ++v;
  EXPECT_EQ(vertex_components(mesh), (std::vector{0, 1, 1, 1, 1}));
}

}  // namespace
}  // namespace isomatch
