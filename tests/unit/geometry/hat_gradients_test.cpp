// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/hat_gradients.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace isomatch {
namespace {

TEST(HatGradients, GiveTheGradientOfALinearField) {
  const Mesh mesh = test::rough_sphere(2, 0.3, 3);
  const Point slope(1, -2, 0.5);
  for (int f = 0; f < mesh.num_faces(); ++f) {
    const Face& face = mesh.faces[f];
    const std::array<Point, 3> gradients = hat_gradients(mesh, face);
    Point sum(0, 0, 0);
    for (int k = 0; k < 3; ++k) sum += slope.dot(mesh.vertices[face[k]]) * gradients[k];
    const Point normal = area_vector(mesh.vertices, face).normalized();
    const Point tangent = slope - slope.dot(normal) * normal;
    // Some roundings of doubles near 1.
    EXPECT_LT((sum - face_area(mesh, f) * tangent).norm(), 1e-14);
  }
}

TEST(HatGradients, VanishOnADegenerateFace) {
  const Mesh mesh{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}};
  for (const Point& gradient : hat_gradients(mesh, mesh.faces[0]))
    EXPECT_EQ(gradient, Point(0, 0, 0));
}

TEST(AreaVector, IsTwiceTheAreaLong) {
  const Mesh mesh{{{0, 0, 1}, {3, 0, 1}, {0, 2, 1}}, {{0, 1, 2}}};
  EXPECT_EQ(area_vector(mesh.vertices, mesh.faces[0]), Point(0, 0, 6));
}

}  // namespace
}  // namespace isomatch
