// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/surface.h"

#include <gtest/gtest.h>

#include <utility>

#include "support/shapes.h"
#include "unit/tracked/prepared.h"

namespace isomatch::tracked {
namespace {

TEST(Surface, HasUnitAreaAndTheWayBack) {
  const test::Prepared prepared(test::rough_sphere(2, 0.2, 1));
  const Surface& surface = prepared.surface;
  EXPECT_NEAR(surface_area(surface.mesh), 1, 1e-12);
  EXPECT_TRUE(surface.oriented);
  for (int v = 0; v < prepared.shape.num_vertices(); ++v) {
    const Point back = surface.scale * surface.mesh.vertices[v] + surface.centre;
    EXPECT_LT((back - prepared.shape.surface.mesh.vertices[v]).norm(), 1e-12);
    EXPECT_GT(surface.normals[v].dot(back), 0);
  }
}

TEST(Surface, KnowsWhichFacesItTurned) {
  Mesh spotted = test::icosphere(3);
  for (int f = 0; f < spotted.num_faces(); f += 10)
    std::swap(spotted.faces[f][0], spotted.faces[f][1]);
  const Shape shape = prepare_shape(spotted);
  const Surface surface = unit_surface(shape.surface),
                    mirrored = unit_surface(shape.surface, true);
  for (int f = 0; f < spotted.num_faces(); ++f) {
    Face face = shape.surface.mesh.faces[f];
    EXPECT_EQ(surface.turned[f], shape.surface.input_face[f] % 10 == 0);
    EXPECT_NE(mirrored.turned[f], surface.turned[f]);
    if (surface.turned[f]) std::swap(face[1], face[2]);
    EXPECT_EQ(surface.mesh.faces[f], face);
  }
}

}  // namespace
}  // namespace isomatch::tracked
