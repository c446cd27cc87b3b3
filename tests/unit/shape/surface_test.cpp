// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

TEST(Surface, HasUnitAreaAndTheWayBack) {
  const Mesh mesh = test::rough_sphere(2, 0.2, 1);
  const Surface surface = unit_surface(extract_surface(mesh));
  EXPECT_NEAR(surface_area(surface.mesh), 1, 1e-12);
  EXPECT_TRUE(surface.oriented);
  ASSERT_EQ(surface.num_vertices(), mesh.num_vertices());
  for (int v = 0; v < surface.num_vertices(); ++v) {
    const Point back = surface.scale * surface.mesh.vertices[v] + surface.centre;
    EXPECT_LT((back - mesh.vertices[surface.input_vertex[v]]).norm(), 1e-12);
    EXPECT_GT(surface.normals[v].dot(back), 0);
  }
  EXPECT_NEAR(std::accumulate(surface.vertex_areas.begin(), surface.vertex_areas.end(), 0.0), 1,
              1e-12);
}

TEST(Surface, KnowsWhichFacesItTurned) {
  Mesh spotted = test::icosphere(3);
  for (int f = 0; f < spotted.num_faces(); f += 10)
    std::swap(spotted.faces[f][0], spotted.faces[f][1]);
  const ExtractedSurface extracted = extract_surface(spotted);
  const Surface surface = unit_surface(extracted), mirrored = mirror_image(surface);
  for (int f = 0; f < spotted.num_faces(); ++f) {
    Face face = extracted.mesh.faces[f];
    EXPECT_EQ(surface.turned[f], extracted.input_face[f] % 10 == 0);
    EXPECT_NE(mirrored.turned[f], surface.turned[f]);
    if (surface.turned[f]) std::swap(face[1], face[2]);
    EXPECT_EQ(surface.mesh.faces[f], face);
  }
}

/// Volume that the surface encloses, negative if its faces are turned inwards.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces)
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6;
  return sum;
}

TEST(MirrorImage, OfAClosedSurfaceFacesOutwards) {
  Mesh inside_out = test::rough_sphere(3, 0.2, 1);
  for (Face& face : inside_out.faces) std::swap(face[0], face[1]);
  for (const Mesh& mesh : {test::rough_sphere(3, 0.2, 1), inside_out, test::torus(40, 20),
                           test::sphere_with_flipped_faces()}) {
    const Surface surface = unit_surface(extract_surface(mesh)), image = mirror_image(surface);
    ASSERT_TRUE(image.oriented);
    EXPECT_GT(volume(image.mesh), 0);
    EXPECT_NEAR(volume(image.mesh), volume(surface.mesh), 1e-12);
    const std::vector<Point> normals = unit_normals(image.mesh);
    for (int v = 0; v < image.num_vertices(); ++v) {
      EXPECT_LT((image.normals[v] - normals[v]).norm(), 1e-12);
      const Point& p = surface.mesh.vertices[v];
      EXPECT_EQ(image.mesh.vertices[v], Point(-p.x(), p.y(), p.z()));
    }
  }
}

TEST(MirrorImage, KeepsNumbersAndTwiceIsNothing) {
  for (const test::ZooMesh& zoo_mesh : test::mesh_zoo()) {
    SCOPED_TRACE(zoo_mesh.name);
    const Surface surface = unit_surface(extract_surface(zoo_mesh.mesh));
    const Surface image = mirror_image(surface), again = mirror_image(image);
    EXPECT_EQ(image.input_vertex, surface.input_vertex);
    EXPECT_EQ(image.surface_vertex, surface.surface_vertex);
    EXPECT_EQ(image.input_face, surface.input_face);
    EXPECT_EQ(image.vertex_areas, surface.vertex_areas);
    EXPECT_EQ(again.mesh.vertices, surface.mesh.vertices);
    EXPECT_EQ(again.mesh.faces, surface.mesh.faces);
    EXPECT_EQ(again.turned, surface.turned);
    EXPECT_EQ(again.normals, surface.normals);
  }
}

class SurfaceZoo : public testing::TestWithParam<test::ZooMesh> {};

TEST_P(SurfaceZoo, ListsTheVerticesOfTheMeshAtEachVertex) {
  const Surface surface = unit_surface(extract_surface(GetParam().mesh));
  std::vector<int> found(GetParam().mesh.vertices.size(), kNoVertex);
  for (int v = 0; v < surface.num_vertices(); ++v) {
    const auto all = surface.input_vertices[v];
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all.front(), surface.input_vertex[v]);
    EXPECT_TRUE(std::ranges::is_sorted(all));
    for (int i : all) found[i] = v;
  }
  EXPECT_EQ(found, surface.surface_vertex);
}

INSTANTIATE_TEST_SUITE_P(All, SurfaceZoo, testing::ValuesIn(test::mesh_zoo()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace isomatch
