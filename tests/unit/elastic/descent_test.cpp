// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/descent.h"

#include <gtest/gtest.h>

#include <vector>

#include "elastic/projection.h"
#include "support/random.h"
#include "support/shapes.h"

namespace isomatch::elastic {
namespace {

class DescentOnASphere : public testing::Test {
 protected:
  Mesh mesh_ = test::icosphere(4);
  IndexLists faces_ = vertex_faces(mesh_);
  std::vector<Point> normals_ = mesh_.vertices;
  std::vector<Features> features_{mesh_.vertices.size()};
  Descent descent_{mesh_, faces_, normals_, features_, {}};
};

TEST_F(DescentOnASphere, EndsWhereASearchOfAllVerticesDoes) {
  const Projection projection(mesh_, faces_, normals_, features_, {});
  test::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Point normal = random.direction();
    const Point position = (0.8 + 0.4 * random.uniform()) * normal;
    const int start = static_cast<int>(random.uniform() * mesh_.num_vertices());
    const Foot found = descent_(start, position, normal, {});
    const Foot expected = projection(position, normal, {});
    EXPECT_EQ(found.face, expected.face);
    EXPECT_EQ(found.weights, expected.weights);
  }
}

TEST_F(DescentOnASphere, StaysWhereNoNeighbourIsCloser) {
  for (int v = 0; v < mesh_.num_vertices(); ++v)
    EXPECT_EQ(descent_.nearest_vertex(v, 1.1 * mesh_.vertices[v], normals_[v], {}), v);
}

TEST_F(DescentOnASphere, FollowsFeatures) {
  for (std::size_t v = 0; v < features_.size(); ++v) features_[v].place[0] = mesh_.vertices[v].z();
  const Descent by_place(mesh_, faces_, normals_, features_, {.normal = 0, .place = 100});
  Features wanted;
  wanted.place[0] = -1;
  const int end = by_place.nearest_vertex(0, {0, 0, 1}, {0, 0, 1}, wanted);
  EXPECT_LT(mesh_.vertices[end].z(), -0.99);
}

}  // namespace
}  // namespace isomatch::elastic
