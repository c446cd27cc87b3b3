// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/extraction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

/// The faces with their vertices in ascending order, sorted: what is left without any numbering.
std::vector<Face> sorted_faces(const Mesh& mesh) {
  std::vector<Face> faces = mesh.faces;
  for (Face& face : faces) std::ranges::sort(face);
  std::ranges::sort(faces);
  return faces;
}

TEST(ExtractedSurface, TakesTheComponentOfLargestArea) {
  const ExtractedSurface surface = extract_surface(test::three_spheres());
  EXPECT_EQ(surface.components, 3);
  EXPECT_EQ(surface.num_vertices(), 162);
  EXPECT_EQ(surface.mesh.num_faces(), 320);
  for (int v : surface.input_vertex) EXPECT_EQ(v / 162, 1);
  for (int v = 0; v < 3 * 162; ++v) EXPECT_EQ(surface.surface_vertex[v] == kNoVertex, v / 162 != 1);
}

TEST(ExtractedSurface, AreaCountsMoreThanFaces) {
  // A fine small sphere has more faces than a coarse large one.
  const ExtractedSurface surface =
      extract_surface(test::combined(test::icosphere(3, 1), test::scaled(test::box(1), 10)));
  EXPECT_EQ(surface.num_vertices(), 8);
  EXPECT_NEAR(surface.area, 600, 1e-9);
  EXPECT_NEAR(surface.total_area, 600 + surface_area(test::icosphere(3, 1)), 1e-9);
}

TEST(ExtractedSurface, LeavesOutDegenerateFaces) {
  const ExtractedSurface surface = extract_surface(test::sphere_with_degenerate_faces());
  EXPECT_EQ(surface.degenerate_faces, 4);
  EXPECT_EQ(surface.num_vertices(), 162);
  EXPECT_EQ(surface.mesh.num_faces(), 320);
  for (int v = 162; v < 166; ++v) EXPECT_EQ(surface.surface_vertex[v], kNoVertex);
}

TEST(ExtractedSurface, ZeroAreaIsFoundWhereCoordinatesRound) {
  test::Random random(11);
  for (int i = 0; i < 50; ++i) {
    const Mesh mesh = test::moved(test::sphere_with_degenerate_faces(), random);
    EXPECT_EQ(extract_surface(mesh).degenerate_faces, 4);
  }
}

TEST(ExtractedSurface, KeepsSliversOfAnyUnit) {
  // Height 1e-9 of the length: thin, but far from the rounding of its coordinates.
  for (double unit : {1e-30, 1e-6, 1.0, 1e30}) {
    const Mesh sliver{{Point(0, 0, 0), Point(unit, 0, 0), Point(unit / 2, 1e-9 * unit, 0)},
                      {{0, 1, 2}}};
    EXPECT_EQ(extract_surface(sliver).mesh.num_faces(), 1) << unit;
  }
}

TEST(ExtractedSurface, KeepsTheLowestOfDuplicateFaces) {
  const ExtractedSurface surface = extract_surface(test::sphere_with_duplicate_faces());
  EXPECT_EQ(surface.duplicate_faces, 3);
  std::set<int> kept(surface.input_face.begin(), surface.input_face.end());
  EXPECT_EQ(kept.size(), 320u);
  EXPECT_EQ(*kept.rbegin(), 319);
}

TEST(ExtractedSurface, SpareCopiesAtThePolesGoWithTheSurface) {
  const Mesh mesh = test::uv_sphere(16, 8);
  const ExtractedSurface surface = extract_surface(mesh);
  EXPECT_EQ(std::ranges::count(surface.surface_vertex, kNoVertex), 0);
  for (int i = 0; i <= 16; ++i) EXPECT_EQ(surface.surface_vertex[i], surface.surface_vertex[0]);
}

TEST(ExtractedSurface, RefusesMeshesWithoutSurface) {
  EXPECT_THROW(extract_surface({}), InvalidInput);
  const Mesh line{{Point(0, 0, 0), Point(1, 1, 1), Point(2, 2, 2)}, {{0, 1, 2}, {0, 0, 1}}};
  EXPECT_THROW(extract_surface(line), InvalidInput);
  const Mesh point{std::vector<Point>(3, Point(4, 5, 6)), {{0, 1, 2}}};
  EXPECT_THROW(extract_surface(point), InvalidInput);
}

TEST(ExtractedSurface, HilbertCurveGoesFromCellToCell) {
  // On a full lattice of 2^k points a side the curve visits every point before it leaves its
  // neighbourhood: consecutive points are exactly one step apart.
  constexpr int kSide = 8;
  Mesh mesh;
  const auto number = [](int x, int y, int z) { return (z * kSide + y) * kSide + x; };
  for (int z = 0; z < kSide; ++z) {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        mesh.vertices.emplace_back(x, y, z);
        if (x > 0 && y > 0)
          mesh.faces.push_back({number(x, y, z), number(x - 1, y, z), number(x, y - 1, z)});
        if (x > 0 && z > 0)
          mesh.faces.push_back({number(x, y, z), number(x - 1, y, z), number(x, y, z - 1)});
      }
    }
  }
  // Every lattice point has a face but for those of which all neighbours are ahead.
  mesh.faces.push_back({number(0, 0, 0), number(1, 0, 0), number(0, 1, 0)});
  const ExtractedSurface surface = extract_surface(mesh);
  ASSERT_EQ(surface.components, 1);
  int used = 0;
  for (int v = 1; v < surface.num_vertices(); ++v) {
    const Point step = surface.mesh.vertices[v] - surface.mesh.vertices[v - 1];
    used += step.squaredNorm() == 1;
  }
  EXPECT_EQ(surface.num_vertices(), kSide * kSide * kSide);
  EXPECT_EQ(used, surface.num_vertices() - 1);
}

class ExtractedSurfaceZoo : public ::testing::TestWithParam<test::ZooMesh> {};
INSTANTIATE_TEST_SUITE_P(All, ExtractedSurfaceZoo, ::testing::ValuesIn(test::mesh_zoo()));

TEST_P(ExtractedSurfaceZoo, MapsLeadThereAndBack) {
  const Mesh& input = GetParam().mesh;
  const ExtractedSurface surface = extract_surface(input);
  ASSERT_EQ(surface.surface_vertex.size(), input.vertices.size());
  ASSERT_EQ(surface.input_vertex.size(), surface.mesh.vertices.size());
  ASSERT_EQ(surface.input_face.size(), surface.mesh.faces.size());
  for (int v = 0; v < surface.num_vertices(); ++v) {
    EXPECT_EQ(surface.surface_vertex[surface.input_vertex[v]], v);
    EXPECT_EQ(surface.mesh.vertices[v], input.vertices[surface.input_vertex[v]]);
  }
  for (int v = 0; v < input.num_vertices(); ++v) {
    if (surface.surface_vertex[v] == kNoVertex) continue;
    EXPECT_EQ(surface.mesh.vertices[surface.surface_vertex[v]], input.vertices[v]);
  }
  for (int f = 0; f < surface.mesh.num_faces(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int input_vertex = input.faces[surface.input_face[f]][corner];
      EXPECT_EQ(surface.mesh.faces[f][corner], surface.surface_vertex[input_vertex]);
    }
  }
}

TEST_P(ExtractedSurfaceZoo, IsConnectedAndSound) {
  const ExtractedSurface surface = extract_surface(GetParam().mesh);
  EXPECT_NO_THROW(validate(surface.mesh));
  for (int label : vertex_components(surface.mesh)) EXPECT_EQ(label, 0);
  for (int f = 0; f < surface.mesh.num_faces(); ++f) EXPECT_GT(face_area(surface.mesh, f), 0);
  std::vector<Face> faces = sorted_faces(surface.mesh);
  EXPECT_EQ(std::ranges::adjacent_find(faces), faces.end());
  // Sums of the same terms in another order.
  EXPECT_NEAR(surface.area, surface_area(surface.mesh), 1e-12 * surface.area);
  EXPECT_LE(surface.area, surface.total_area);
}

TEST_P(ExtractedSurfaceZoo, IsItsOwnSurface) {
  const ExtractedSurface surface = extract_surface(GetParam().mesh);
  const ExtractedSurface again = extract_surface(surface.mesh);
  EXPECT_EQ(again.num_vertices(), surface.num_vertices());
  EXPECT_EQ(again.mesh.num_faces(), surface.mesh.num_faces());
  EXPECT_EQ(again.degenerate_faces + again.duplicate_faces + again.joined_edges, 0);
}

TEST_P(ExtractedSurfaceZoo, DoesNotDependOnLabels) {
  test::Random random(17);
  const ExtractedSurface surface = extract_surface(GetParam().mesh);
  const ExtractedSurface other = extract_surface(test::relabelled(GetParam().mesh, random).mesh);
  EXPECT_EQ(other.mesh.vertices, surface.mesh.vertices);
  EXPECT_EQ(sorted_faces(other.mesh), sorted_faces(surface.mesh));
  EXPECT_EQ(other.joined_edges, surface.joined_edges);
}

TEST_P(ExtractedSurfaceZoo, DoesNotDependOnUnits) {
  // Powers of two scale coordinates without rounding.
  const ExtractedSurface surface = extract_surface(GetParam().mesh);
  for (double factor : {0x1p-100, 0x1p100}) {
    const ExtractedSurface other = extract_surface(test::scaled(GetParam().mesh, factor));
    EXPECT_EQ(other.mesh.faces, surface.mesh.faces);
    EXPECT_EQ(other.input_vertex, surface.input_vertex);
    EXPECT_EQ(other.area, surface.area * factor * factor);
  }
}

}  // namespace
}  // namespace isomatch
