// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/tangent_field.h"

#include <gtest/gtest.h>

#include <vector>

#include "shape/surface.h"
#include "support/shapes.h"

namespace isomatch::tracked {
namespace {

TEST(TangentField, OneVertexPullsAllOfAPlaneAlongInParallel) {
  const Mesh plane = test::sheet(8, 8);
  const Connection connection(plane, unit_normals(plane));
  std::vector<Pull> pulls(plane.vertices.size());
  pulls[20] = {Eigen::Matrix2d::Identity(), Tangent(0.3, -0.2)};
  const TangentField field = connection.balanced(pulls, 10);
  // Parallel vectors cost nothing. As exact as the iteration is.
  for (const Tangent& t : field) EXPECT_LT((t - pulls[20].force).norm(), 1e-2);
}

TEST(TangentField, WhatDoesNotCountAsSmoothFollowsItsOwnPull) {
  const Mesh sphere = test::icosphere(2);
  const Connection connection(sphere, unit_normals(sphere));
  std::vector<Pull> pulls;
  for (int v = 0; v < sphere.num_vertices(); ++v)
    pulls.push_back({2 * Eigen::Matrix2d::Identity(), Tangent(v, 1)});
  const TangentField field = connection.balanced(pulls, 0);
  for (int v = 0; v < sphere.num_vertices(); ++v)
    EXPECT_LT((field[v] - Tangent(v / 2.0, 0.5)).norm(), 1e-9 * (1 + v));
}

TEST(TangentField, NeighboursOnASphereTurnByTheShortestRotation) {
  const Mesh sphere = test::icosphere(3);
  const Connection connection(sphere, unit_normals(sphere));
  for (int v = 0; v < sphere.num_vertices(); ++v) {
    for (const Connection::Link& link : connection.links(v)) {
      EXPECT_NEAR(link.turn.determinant(), 1, 1e-9);
      // Vectors hardly change on their way: edges are .15 of the radius long.
      const Point there = connection.frame(link.to).first;
      const Point here = connection.frame(v).vector(link.turn.col(0));
      EXPECT_LT((here - there).norm(), 0.2);
    }
  }
}

}  // namespace
}  // namespace isomatch::tracked
