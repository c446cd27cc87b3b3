// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/second_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/shapes.h"

namespace isomatch::tracked {
namespace {

TEST(SecondForm, OfASphereIsItsCurvatureInAllDirections) {
  constexpr double kRadius = 0.4;
  const Mesh sphere = test::icosphere(4, kRadius);
  const std::vector<SecondForm> forms = second_forms(sphere, 0.02);
  for (int v = 0; v < sphere.num_vertices(); ++v) {
    const Point first = sphere.vertices[v].unitOrthogonal(),
                second = sphere.vertices[v].cross(first).normalized();
    for (const SymmetricTensor& tensor : forms[v]) {
      const PlaneForm form = in_plane(tensor, first, second);
      EXPECT_NEAR(form.first, 1 / kRadius, 0.05 / kRadius);
      EXPECT_NEAR(form.second, 1 / kRadius, 0.05 / kRadius);
      EXPECT_NEAR(form.mixed, 0, 0.1);
    }
  }
}

TEST(SecondForm, OfACylinderIsZeroAlongIt) {
  constexpr double kRadius = 0.3;
  const Mesh cylinder = test::open_cylinder(60, 60, kRadius, 2);
  const std::vector<SecondForm> forms = second_forms(cylinder, 0.02);
  for (int v = 0; v < cylinder.num_vertices(); ++v) {
    const Point& p = cylinder.vertices[v];
    if (std::abs(p.z() - 1) > 0.7) continue;  // The ends bend less.
    const Point along(0, 0, 1), around = Point(-p.y(), p.x(), 0).normalized();
    for (const SymmetricTensor& tensor : forms[v]) {
      const PlaneForm form = in_plane(tensor, along, around);
      EXPECT_NEAR(form.first, 0, 0.02);
      EXPECT_NEAR(form.second, 1 / kRadius, 0.05 / kRadius);
      EXPECT_NEAR(form.mixed, 0, 0.02);
    }
  }
}

TEST(SecondForm, HasTheSignOfTheSideThatFacesGoAround) {
  Mesh hollow = test::icosphere(3);
  for (Face& face : hollow.faces) std::swap(face[0], face[1]);
  const Point& p = hollow.vertices.front();
  const SecondForm form = second_forms(hollow, 0.05).front();
  EXPECT_LT(in_plane(form[0], p.unitOrthogonal(), p.cross(p.unitOrthogonal())).first, -0.8);
}

}  // namespace
}  // namespace isomatch::tracked
