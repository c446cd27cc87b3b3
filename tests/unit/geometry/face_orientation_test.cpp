// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/face_orientation.h"

#include <gtest/gtest.h>

#include <utility>

#include "support/shapes.h"

namespace isomatch {
namespace {

bool is_one_sided(const Mesh& mesh) {
  DisjointSets cover = orientation_cover(mesh, sorted_edge_sides(mesh));
  return cover.find(0) == cover.find(1);
}

TEST(OrientationCover, ClosesOnOneSidedSurfacesOnly) {
  EXPECT_TRUE(is_one_sided(test::moebius_strip(12)));
  EXPECT_FALSE(is_one_sided(test::torus(12, 8)));
  EXPECT_FALSE(is_one_sided(test::sheet(3, 3)));
}

TEST(FaceOrientation, FindsTheFacesThatAreTurned) {
  Mesh mesh = test::icosphere(2);
  std::vector<signed char> expected(mesh.faces.size(), 1);
  for (std::size_t f = 0; f < mesh.faces.size(); f += 20) {
    std::swap(mesh.faces[f][0], mesh.faces[f][1]);
    expected[f] = -1;
  }
  EXPECT_EQ(face_orientation(mesh), expected);
}

TEST(FaceOrientation, OfAClosedSurfaceIsOutwards) {
  Mesh mesh = test::icosphere(2);
  for (Face& face : mesh.faces) std::swap(face[0], face[1]);
  EXPECT_EQ(face_orientation(mesh), std::vector<signed char>(mesh.faces.size(), -1));
}

TEST(FaceOrientation, IsUnknownOfAOneSidedSurface) {
  EXPECT_EQ(face_orientation(test::moebius_strip(12)), std::nullopt);
}

}  // namespace
}  // namespace isomatch
