// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/descent.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random.h"
#include "support/shapes.h"

namespace isomatch::elastic {
namespace {

class DescentOnASphere : public testing::Test {
 protected:
  Mesh mesh_ = test::icosphere(4);
  IndexLists faces_ = vertex_faces(mesh_);
};

TEST_F(DescentOnASphere, EndsAtTheClosestOfAllVertices) {
  test::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Point position = (0.8 + 0.4 * random.uniform()) * random.direction();
    const auto distance = [&](const Point& p) { return (p - position).squaredNorm(); };
    const auto closest = std::ranges::min_element(mesh_.vertices, {}, distance);
    const int start = static_cast<int>(random.uniform() * mesh_.num_vertices());
    EXPECT_EQ(descend(start, position, mesh_, faces_), closest - mesh_.vertices.begin());
  }
}

TEST_F(DescentOnASphere, StaysWhereNoNeighbourIsCloser) {
  for (int v = 0; v < mesh_.num_vertices(); ++v)
    EXPECT_EQ(descend(v, 1.1 * mesh_.vertices[v], mesh_, faces_), v);
}

}  // namespace
}  // namespace isomatch::elastic
