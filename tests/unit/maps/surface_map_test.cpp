// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/maps/surface_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

using testing::Each;
using testing::ElementsAre;

SurfacePoint random_point(const Mesh& mesh, test::Random& random) {
  const double a = random.uniform(), b = (1 - a) * random.uniform();
  return {random.index(mesh.num_faces()), {a, b, 1 - a - b}};
}

/// A random point of `onto` for every vertex of `from`; every seventh has none.
SurfaceMap random_map(const Surface& from, const Surface& onto, test::Random& random) {
  SurfaceMap map(from.num_vertices());
  for (std::size_t v = 0; v < map.size(); ++v)
    if (v % 7 != 6) map[v] = random_point(onto.mesh, random);
  return map;
}

TEST(SurfacePoint, LiesWhereItsWeightsSay) {
  const Mesh sheet = test::sheet(1, 1, 4, 2);
  const auto& [a, b, c] = sheet.faces[1];
  const Point expected =
      0.5 * sheet.vertices[a] + 0.25 * sheet.vertices[b] + 0.25 * sheet.vertices[c];
  EXPECT_EQ(position(sheet, {1, {0.5, 0.25, 0.25}}), expected);
  EXPECT_EQ(position(sheet, {1, {0, 0, 1}}), sheet.vertices[c]);
}

TEST(NearestVertices, HaveTheLargestWeight) {
  const Mesh sheet = test::sheet(1, 1);
  const Face& face = sheet.faces[1];
  EXPECT_THAT(nearest_vertices(sheet, {{1, {0.2, 0.2, 0.6}}, {}, {1, {0.25, 0.375, 0.375}}}),
              ElementsAre(face[2], kUnmatched, face[1]));
}

class InputMap : public testing::TestWithParam<test::ZooMesh> {};

TEST_P(InputMap, KeepsPositionsAndComesBack) {
  test::Random random(3);
  const Surface source = extract_surface(GetParam().mesh);
  const Mesh target_mesh = test::soup(test::icosphere(1));
  const Surface target = extract_surface(target_mesh);
  for (const auto& [from, onto, mesh] :
       {std::tuple{&source, &target, &target_mesh}, {&target, &source, &GetParam().mesh}}) {
    const SurfaceMap map = random_map(*from, *onto, random);
    const SurfaceMap input = input_map(*from, *onto, map);
    ASSERT_EQ(input.size(), from->surface_vertex.size());
    for (std::size_t v = 0; v < input.size(); ++v) {
      const int vertex = from->surface_vertex[v];
      const bool known = vertex != kNoVertex && map[vertex].face != kNoFace;
      ASSERT_EQ(input[v].face != kNoFace, known);
      if (!known) continue;
      ASSERT_EQ(position(*mesh, input[v]), position(onto->mesh, map[vertex]));
    }
    EXPECT_EQ(surface_map(*from, *onto, input), map);
  }
}

INSTANTIATE_TEST_SUITE_P(All, InputMap, testing::ValuesIn(test::mesh_zoo()));

TEST(SurfaceMapOfInput, DropsFacesOffTheSurface) {
  const Mesh spheres = test::three_spheres();
  const Surface surface = extract_surface(spheres);
  const int last = spheres.num_faces() - 1;
  const SurfaceMap input(spheres.vertices.size(), {last, {1, 0, 0}});
  EXPECT_THAT(surface_map(surface, surface, input), Each(SurfacePoint{}));
  const SurfaceMap first(spheres.vertices.size(), {0, {1, 0, 0}});
  EXPECT_THAT(surface_map(surface, surface, first), Each(SurfacePoint{}));
}

TEST(SurfaceMapOfInput, BadInputThrows) {
  const Surface surface = extract_surface(test::icosphere(1));
  const std::size_t size = surface.surface_vertex.size();
  EXPECT_THROW(surface_map(surface, surface, SurfaceMap(size - 1)), InvalidInput);
  EXPECT_THROW(surface_map(surface, surface, SurfaceMap(size, {-2, {1, 0, 0}})), InvalidInput);
}

TEST(InputPose, SurfaceVerticesAreAtTheirPositions) {
  const Mesh sphere = test::icosphere(2);
  const Mesh charts = test::split_charts(sphere, test::octants(sphere));
  const Surface surface = extract_surface(charts);
  test::Random random(4);
  const Mesh elsewhere = test::moved(surface.mesh, random);
  const Mesh pose = input_pose(charts, surface, elsewhere.vertices);
  EXPECT_EQ(pose.faces, charts.faces);
  for (int v = 0; v < charts.num_vertices(); ++v)
    EXPECT_EQ(pose.vertices[v], elsewhere.vertices[surface.surface_vertex[v]]);
}

TEST(InputPose, OtherVerticesFollowTheNearest) {
  const Mesh sheet = test::sheet(2, 2, 2, 2);
  Mesh mesh = sheet;
  // One over the corner (2, 2), which rises, one over the corner (0, 0), which stays.
  mesh.vertices.insert(mesh.vertices.begin(), {Point(2.1, 2.2, 1), Point(-0.5, 0, -1)});
  for (Face& face : mesh.faces)
    for (int& v : face) v += 2;
  const Surface surface = extract_surface(mesh);
  std::vector<Point> positions = surface.mesh.vertices;
  for (Point& p : positions) p[2] = p[0] + p[1];
  const Mesh pose = input_pose(mesh, surface, positions);
  EXPECT_TRUE(pose.vertices[0].isApprox(Point(2.1, 2.2, 5)));
  EXPECT_TRUE(pose.vertices[1].isApprox(Point(-0.5, 0, -1)));
}

TEST(InputPose, BadInputThrows) {
  const Mesh mesh = test::icosphere(1);
  const Surface surface = extract_surface(mesh);
  std::vector<Point> positions = surface.mesh.vertices;
  EXPECT_THROW(input_pose(test::icosphere(2), surface, positions), InvalidInput);
  positions.pop_back();
  EXPECT_THROW(input_pose(mesh, surface, positions), InvalidInput);
}

}  // namespace
}  // namespace isomatch
