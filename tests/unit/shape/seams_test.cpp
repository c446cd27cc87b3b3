// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// Joining of seams, as seen through extract_surface.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "isomatch/mesh/connectivity.h"
#include "isomatch/mesh/topology.h"
#include "shape/extraction.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

void expect_whole_sphere(const ExtractedSurface& surface) {
  EXPECT_EQ(surface.num_vertices(), 162);
  EXPECT_EQ(surface.mesh.num_faces(), 320);
  const Connectivity counts = connectivity(surface.mesh);
  EXPECT_EQ(counts.boundary_edges, 0);
  EXPECT_EQ(counts.genus(), 0);
}

TEST(Seams, ChartsBecomeOneSphere) {
  expect_whole_sphere(extract_surface(test::sphere_of_charts()));
}

TEST(Seams, LooseTrianglesBecomeOneSphere) {
  const ExtractedSurface surface = extract_surface(test::soup(test::icosphere(2)));
  expect_whole_sphere(surface);
  EXPECT_EQ(surface.joined_edges, 480);
}

TEST(Seams, SplitMeridianCloses) {
  const ExtractedSurface surface = extract_surface(test::uv_sphere(16, 8));
  EXPECT_EQ(surface.num_vertices(), 16 * 7 + 2);
  EXPECT_EQ(connectivity(surface.mesh).genus(), 0);
  EXPECT_EQ(connectivity(surface.mesh).boundary_edges, 0);
}

TEST(Seams, TheLowestOfJoinedVerticesStandsForAll) {
  const Mesh soup = test::soup(test::icosphere(1));
  const ExtractedSurface surface = extract_surface(soup);
  for (int v = 0; v < soup.num_vertices(); ++v) {
    const auto first = std::ranges::find(soup.vertices, soup.vertices[v]);
    EXPECT_EQ(surface.input_vertex[surface.surface_vertex[v]], first - soup.vertices.begin());
  }
}

TEST(Seams, LooseTrianglesKeepTheSurfacesBorders) {
  const Connectivity counts = connectivity(extract_surface(test::soup(test::sheet(5, 3))).mesh);
  EXPECT_EQ(counts, connectivity(test::sheet(5, 3)));
}

TEST(Seams, OrientationPlaysNoPart) {
  Mesh mesh = test::icosphere(2);
  const std::vector<int> chart = test::octants(mesh);
  for (int f = 0; f < mesh.num_faces(); ++f) {
    if (chart[f] % 3 == 0) std::swap(mesh.faces[f][0], mesh.faces[f][1]);
  }
  expect_whole_sphere(extract_surface(test::split_charts(mesh, chart)));
}

TEST(Seams, SlitInASheetCloses) {
  // The middle vertex of a 4 x 4 sheet is split between the faces above and below.
  Mesh mesh = test::sheet(4, 4);
  const int middle = 12, copy = mesh.num_vertices();
  mesh.vertices.push_back(mesh.vertices[middle]);
  for (int f = 0; f < mesh.num_faces() / 2; ++f) std::ranges::replace(mesh.faces[f], middle, copy);
  ASSERT_EQ(connectivity(mesh).boundary_loops, 2);
  const ExtractedSurface surface = extract_surface(mesh);
  EXPECT_EQ(surface.joined_edges, 2);
  EXPECT_EQ(connectivity(surface.mesh), connectivity(test::sheet(4, 4)));
}

TEST(Seams, TouchingInAPointDoesNotJoin) {
  const ExtractedSurface surface = extract_surface(test::sheets_touching_in_a_point());
  EXPECT_EQ(surface.joined_edges, 0);
  EXPECT_EQ(surface.components, 2);
}

TEST(Seams, BorderOnAnInnerEdgeDoesNotJoin) {
  // A wall stands on the middle line of a floor with which it shares positions but no vertices.
  Mesh wall = test::sheet(4, 4);
  for (Point& p : wall.vertices) p = Point(p.x(), 0.5, p.y());
  const ExtractedSurface surface = extract_surface(test::combined(test::sheet(4, 4), wall));
  EXPECT_EQ(surface.joined_edges, 0);
  EXPECT_EQ(surface.components, 2);
}

TEST(Seams, ThreeBordersAtOnePlaceStayOpen) {
  const ExtractedSurface surface = extract_surface(test::three_sheets_on_a_line());
  EXPECT_EQ(surface.joined_edges, 0);
  EXPECT_EQ(surface.components, 3);
  EXPECT_EQ(surface.num_vertices(), 25);
}

TEST(Seams, SheetAndItsCopyStayApart) {
  const ExtractedSurface surface = extract_surface(test::two_sided_sheet());
  EXPECT_EQ(surface.joined_edges, 0);
  EXPECT_EQ(surface.num_vertices(), 25);
  for (int v : surface.input_vertex) EXPECT_LT(v, 25);
}

TEST(Seams, MeshGivenTwiceIsOneSphereAndACopy) {
  const Mesh charts = test::sphere_of_charts();
  const ExtractedSurface surface = extract_surface(test::combined(charts, charts));
  expect_whole_sphere(surface);
  for (int v : surface.input_vertex) EXPECT_LT(v, charts.num_vertices());
}

TEST(Seams, LooseTrianglesGivenTwiceAreOneSphereAndCopies) {
  const Mesh soup = test::soup(test::icosphere(2));
  const ExtractedSurface surface = extract_surface(test::combined(soup, soup));
  expect_whole_sphere(surface);
  EXPECT_EQ(surface.components, 1 + 320);
}

TEST(Seams, NoJoinThatMakesAnEdgeOfFourFaces) {
  // Two squares lie on each other. Both have the triangle (c, a, b), but different ones beyond the
  // chord ab. Joining along ad and db would bring four faces to ab.
  const Point c(0, 0, 0), a(1, 0, 0), b(0, 1, 0), d(1, 1, 0), m(0.6, 0.6, 0);
  const Mesh front{{c, a, b, d}, {{0, 1, 2}, {1, 3, 2}}};
  const Mesh back{{c, a, b, d, m}, {{0, 1, 2}, {1, 3, 4}, {3, 2, 4}, {2, 1, 4}}};
  const ExtractedSurface surface = extract_surface(test::combined(front, back));
  EXPECT_EQ(surface.joined_edges, 0);
  EXPECT_EQ(surface.components, 2);
}

/// Random triangles between few places, some of which share vertices and some only positions.
Mesh random_tangle(test::Random& random) {
  Mesh mesh;
  const int places = 4 + random.index(6), copies = 1 + random.index(3);
  std::vector<Point> points(places);
  for (Point& p : points) p = random.direction();
  for (int i = 0; i < copies; ++i)
    mesh.vertices.insert(mesh.vertices.end(), points.begin(), points.end());
  const int faces = 1 + random.index(25);
  for (int f = 0; f < faces; ++f) {
    Face face;
    for (int& v : face) v = random.index(mesh.num_vertices());
    mesh.faces.push_back(face);
  }
  mesh.faces.push_back({0, 1, 2});
  return mesh;
}

/// The edges of more than two faces that consist of more than one edge of the input.
int new_nonmanifold_edges(const Mesh& input, const ExtractedSurface& surface) {
  int count = 0;
  for_each_edge(sorted_edge_sides(surface.mesh), [&](std::span<const EdgeSide> sides) {
    std::set<std::pair<int, int>> input_edges;
    for (const EdgeSide& side : sides) {
      const Face& face = input.faces[surface.input_face[side.face]];
      input_edges.insert(std::minmax(face[(side.corner + 1) % 3], face[(side.corner + 2) % 3]));
    }
    count += sides.size() > 2 && input_edges.size() > 1;
  });
  return count;
}

TEST(Seams, TanglesGetNoNewNonManifoldEdgesAndNoEqualFaces) {
  test::Random random(23);
  int joined = 0;
  for (int i = 0; i < 3000; ++i) {
    const Mesh input = random_tangle(random);
    const ExtractedSurface surface = extract_surface(input);
    joined += surface.joined_edges;
    EXPECT_EQ(new_nonmanifold_edges(input, surface), 0) << "tangle " << i;
    std::set<std::set<int>> faces;
    for (const auto& [a, b, c] : surface.mesh.faces) faces.insert({a, b, c});
    EXPECT_EQ(faces.size(), surface.mesh.faces.size()) << "tangle " << i;
    for (const std::set<int>& face : faces) EXPECT_EQ(face.size(), 3u) << "tangle " << i;
  }
  EXPECT_GT(joined, 1000);
}

}  // namespace
}  // namespace isomatch
