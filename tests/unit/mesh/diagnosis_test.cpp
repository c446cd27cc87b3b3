// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/shape/diagnosis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "isomatch/error.h"
#include "shape/inspection.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Diagnosis, CleanMeshHasNothingToReport) {
  const Mesh mesh = test::torus(24, 12);
  const MeshDiagnosis diagnosis = diagnose(mesh);
  EXPECT_EQ(diagnosis.vertices, 288);
  EXPECT_EQ(diagnosis.faces, 576);
  EXPECT_DOUBLE_EQ(diagnosis.area, surface_area(mesh));
  EXPECT_EQ(diagnosis.degenerate_faces, 0);
  EXPECT_EQ(diagnosis.duplicate_faces, 0);
  EXPECT_EQ(diagnosis.unreferenced_vertices, 0);
  EXPECT_EQ(diagnosis.duplicate_vertices, 0);
  EXPECT_EQ(diagnosis.given, connectivity(mesh));
  EXPECT_EQ(diagnosis.surface, connectivity(mesh));
  EXPECT_EQ(diagnosis.components, 1);
  EXPECT_EQ(diagnosis.joined_edges, 0);
  EXPECT_EQ(diagnosis.matchable_vertices, 288);
  EXPECT_EQ(diagnosis.matchable_area_share, 1);
  EXPECT_THAT(diagnosis.warnings(), IsEmpty());
}

TEST(Diagnosis, EdgeLengthsOfACube) {
  const MeshDiagnosis diagnosis = diagnose(test::box(1, Point(2, 2, 2)));
  EXPECT_DOUBLE_EQ(diagnosis.min_edge, 2);
  EXPECT_DOUBLE_EQ(diagnosis.max_edge, 2 * std::sqrt(2));
  EXPECT_DOUBLE_EQ(diagnosis.mean_edge, (12 * 2 + 6 * 2 * std::sqrt(2)) / 18);
}

TEST(Diagnosis, ComponentsByArea) {
  const MeshDiagnosis diagnosis = diagnose(test::three_spheres());
  EXPECT_EQ(diagnosis.given.components, 3);
  EXPECT_EQ(diagnosis.components, 3);
  EXPECT_EQ(diagnosis.matchable_vertices, 162);
  // Areas are as the squares of the radii, up to rounding.
  EXPECT_NEAR(diagnosis.matchable_area_share, 1 / (1 + 0.25 * 0.25 + 0.5 * 0.5), 1e-12);
  EXPECT_EQ(diagnosis.surface.genus(), 0);
  EXPECT_THAT(diagnosis.warnings(),
              ElementsAre("3 components: the largest (76 % of the area) is matched, the other 2 "
                          "follow"));
}

TEST(Diagnosis, FacesThatCarryNoSurface) {
  const MeshDiagnosis degenerate = diagnose(test::sphere_with_degenerate_faces());
  EXPECT_EQ(degenerate.degenerate_faces, 4);
  EXPECT_EQ(degenerate.unreferenced_vertices, 0);
  EXPECT_EQ(degenerate.surface.genus(), 0);
  EXPECT_EQ(degenerate.matchable_vertices, 162);
  EXPECT_THAT(degenerate.warnings(), ElementsAre("4 faces without area: ignored"));

  const MeshDiagnosis duplicate = diagnose(test::sphere_with_duplicate_faces());
  EXPECT_EQ(duplicate.duplicate_faces, 3);
  EXPECT_EQ(duplicate.given.nonmanifold_edges, 0);
  EXPECT_EQ(duplicate.surface.genus(), 0);
  EXPECT_THAT(duplicate.warnings(), ElementsAre("3 faces that repeat others: ignored"));
}

TEST(Diagnosis, VerticesWithoutAFace) {
  const MeshDiagnosis diagnosis = diagnose(test::sphere_with_unreferenced_vertices());
  EXPECT_EQ(diagnosis.vertices, 167);
  EXPECT_EQ(diagnosis.unreferenced_vertices, 5);
  EXPECT_EQ(diagnosis.duplicate_vertices, 0);
  EXPECT_EQ(diagnosis.given.vertices, 162);
  EXPECT_EQ(diagnosis.matchable_vertices, 162);
  EXPECT_THAT(diagnosis.warnings(),
              ElementsAre("5 vertices without a face: matched only where they "
                          "coincide with others"));
}

TEST(Diagnosis, TextureSeams) {
  const MeshDiagnosis diagnosis = diagnose(test::uv_sphere(16, 8));
  EXPECT_EQ(diagnosis.vertices, 17 * 9);
  EXPECT_EQ(diagnosis.duplicate_vertices, 7 + 2 * 16);
  EXPECT_EQ(diagnosis.degenerate_faces, 2 * 16);
  EXPECT_EQ(diagnosis.given.boundary_edges, 2 * diagnosis.joined_edges);
  EXPECT_EQ(diagnosis.joined_edges, 8 + 2 * 15);
  EXPECT_EQ(diagnosis.surface.genus(), 0);
  EXPECT_EQ(diagnosis.surface.boundary_edges, 0);
  EXPECT_EQ(diagnosis.matchable_vertices, diagnosis.vertices);
  EXPECT_THAT(diagnosis.warnings(),
              ElementsAre("32 faces without area: ignored",
                          "38 open seam edges whose two sides coincide: joined"));
}

TEST(Diagnosis, ChartsAreOneComponentOnceJoined) {
  const MeshDiagnosis diagnosis = diagnose(test::sphere_of_charts());
  EXPECT_EQ(diagnosis.given.components, 8);
  EXPECT_EQ(diagnosis.given.boundary_loops, 8);
  EXPECT_EQ(diagnosis.given.boundary_edges, 2 * diagnosis.joined_edges);
  EXPECT_EQ(diagnosis.components, 1);
  EXPECT_EQ(diagnosis.surface.genus(), 0);
  EXPECT_EQ(diagnosis.duplicate_vertices, diagnosis.vertices - 162);
}

TEST(Diagnosis, OpenAndNonManifoldSurfacesWarn) {
  EXPECT_THAT(diagnose(test::sphere_with_hole()).warnings(),
              ElementsAre("1 hole or open border (3 edges): distances lead around; with a long "
                          "border a shape is taken for a part"));
  EXPECT_THAT(diagnose(test::sphere_with_fin()).warnings(),
              ElementsAre("1 edge of more than two faces: the surface branches there",
                          ::testing::StartsWith("1 hole or open border (2 edges)")));
  EXPECT_THAT(diagnose(test::bow_tie()).warnings(),
              ElementsAre("1 vertex in which parts of the surface only touch: distances pass "
                          "through it"));
  EXPECT_THAT(diagnose(test::moebius_strip(24)).warnings(),
              ElementsAre(::testing::StartsWith("1 hole or open border (48 edges)"),
                          ::testing::HasSubstr("Moebius")));
  EXPECT_THAT(diagnose(test::sphere_with_flipped_faces()).warnings(),
              ElementsAre(::testing::HasSubstr("face opposite ways")));
}

void append(const Mesh& part, const Point& shift, Mesh& mesh) {
  const int first = mesh.num_vertices();
  for (const Point& p : part.vertices) mesh.vertices.push_back(p + shift);
  for (const auto& [a, b, c] : part.faces) mesh.faces.push_back({a + first, b + first, c + first});
}

TEST(Diagnosis, ASpikeIsLeftOutOfTheSurface) {
  Mesh mesh = test::torus(48, 24);
  const double area = surface_area(mesh);
  mesh.vertices[100] *= 20;
  const Inspection inspection = inspect(mesh);
  EXPECT_EQ(inspection.diagnosis.stray_vertices, 1);
  EXPECT_EQ(inspection.surface->surface_vertex[100], kNoVertex);
  EXPECT_EQ(inspection.diagnosis.matchable_vertices, mesh.num_vertices() - 1);
  EXPECT_NEAR(inspection.surface->area, area, 0.02 * area);
  EXPECT_THAT(inspection.diagnosis.grave_warnings(),
              ElementsAre("1 stray vertex far outside of the shape: left out, unmatched"));
}

TEST(Diagnosis, SeveralSpikesThatHangTogetherAreLeftOut) {
  Mesh mesh = test::torus(48, 24);
  for (int v : mesh.faces[0]) mesh.vertices[v].z() += 50;
  EXPECT_EQ(diagnose(mesh).stray_vertices, 3);
}

TEST(Diagnosis, AFinelyMeshedHeadDoesNotMakeTheBodyAStray) {
  // More than 99 of 100 vertices are in a ball, the others on a tube that is thirty radii long.
  Mesh mesh = test::icosphere(5, 0.1);
  append(test::open_cylinder(3, 30, 0.05, 3), Point(0, 0, 0.1), mesh);
  const auto top = std::ranges::max_element(mesh.vertices.begin(), mesh.vertices.begin() + 10242,
                                            {}, [](const Point& p) { return p.z(); });
  mesh.faces.push_back({10242, 10243, static_cast<int>(top - mesh.vertices.begin())});
  EXPECT_EQ(diagnose(mesh).stray_vertices, 0);
}

TEST(Diagnosis, VerticesThatAreNoNumbersAreUnmatchedAndNotRefused) {
  Mesh mesh = test::torus(48, 24);
  mesh.vertices[7].y() = std::nan("");
  mesh.vertices[300].x() = std::numeric_limits<double>::infinity();
  const Inspection inspection = inspect(mesh);
  EXPECT_EQ(inspection.diagnosis.not_finite_vertices, 2);
  EXPECT_EQ(inspection.diagnosis.duplicate_vertices, 0);
  EXPECT_EQ(inspection.diagnosis.stray_vertices, 0);
  EXPECT_EQ(inspection.surface->surface_vertex[7], kNoVertex);
  EXPECT_EQ(inspection.surface->surface_vertex[300], kNoVertex);
  EXPECT_EQ(inspection.diagnosis.matchable_vertices, mesh.num_vertices() - 2);
  EXPECT_TRUE(std::isfinite(inspection.diagnosis.area));
  EXPECT_THAT(inspection.diagnosis.warnings(),
              ::testing::Contains("2 vertices with coordinates that are not numbers: unmatched"));
  EXPECT_THAT(inspection.diagnosis.grave_warnings(), IsEmpty());
}

TEST(Diagnosis, EdgesFarBeyondTheirSurroundingsAreGrave) {
  Mesh mesh = test::torus(120, 60);
  EXPECT_EQ(diagnose(mesh).long_edges, 0);
  mesh.vertices[100] *= 3;  // Not far enough to be left out.
  const MeshDiagnosis diagnosis = diagnose(mesh);
  EXPECT_EQ(diagnosis.stray_vertices, 0);
  EXPECT_EQ(diagnosis.long_edges, 6);
  EXPECT_THAT(diagnosis.grave_warnings(), ElementsAre(::testing::HasSubstr("6 edges far longer")));
}

TEST(Diagnosis, SeamsThatNearlyCoincideAreGrave) {
  Mesh mesh = test::rolled_sheet(40, 20, 2, 1, 2 * std::numbers::pi - 1e-6);
  const MeshDiagnosis diagnosis = diagnose(mesh);
  EXPECT_EQ(diagnosis.near_seam_vertices, 2 * 21);
  EXPECT_THAT(diagnosis.grave_warnings(), ElementsAre(::testing::HasSubstr("nearly coincide")));
  EXPECT_EQ(diagnose(test::rolled_sheet(40, 20, 2, 1, 6)).near_seam_vertices, 0);
}

TEST(Diagnosis, LessThanHalfOfTheAreaIsGrave) {
  Mesh mesh;
  for (int k = 0; k < 3; ++k) append(test::icosphere(2), Point(3 * k, 0, 0), mesh);
  const MeshDiagnosis diagnosis = diagnose(mesh);
  EXPECT_NEAR(diagnosis.matchable_area_share, 1.0 / 3, 1e-6);
  EXPECT_THAT(diagnosis.grave_warnings(), ElementsAre(::testing::HasSubstr("is matched")));
  EXPECT_THAT(diagnose(test::three_spheres()).grave_warnings(), IsEmpty());
}

TEST(Diagnosis, UnitsOfWhichAreasAreNotFiniteAreRefused) {
  EXPECT_THROW(diagnose(test::scaled(test::torus(24, 12), 1e160)), InvalidInput);
  EXPECT_THROW(extract_surface(test::scaled(test::torus(24, 12), 1e160)), InvalidInput);
}

TEST(Diagnosis, MeshWithoutAreaIsDiagnosedNotRefused) {
  const Mesh mesh{{Point(0, 0, 0), Point(1, 1, 1), Point(2, 2, 2)}, {{0, 1, 2}, {0, 0, 1}}};
  const MeshDiagnosis diagnosis = diagnose(mesh);
  EXPECT_EQ(diagnosis.degenerate_faces, 2);
  EXPECT_EQ(diagnosis.matchable_vertices, 0);
  EXPECT_EQ(diagnosis.surface, Connectivity());
  EXPECT_THAT(diagnosis.warnings(), ElementsAre("no face has an area: there is nothing to match"));
  EXPECT_THROW(diagnose({}), InvalidInput);
}

class DiagnosisZoo : public ::testing::TestWithParam<test::ZooMesh> {};
INSTANTIATE_TEST_SUITE_P(All, DiagnosisZoo, ::testing::ValuesIn(test::mesh_zoo()));

TEST_P(DiagnosisZoo, AgreesWithExtraction) {
  const MeshDiagnosis diagnosis = diagnose(GetParam().mesh);
  const ExtractedSurface surface = extract_surface(GetParam().mesh);
  EXPECT_EQ(diagnosis.surface, connectivity(surface.mesh));
  EXPECT_EQ(diagnosis.surface.components, 1);
  EXPECT_EQ(diagnosis.components, surface.components);
  EXPECT_EQ(diagnosis.degenerate_faces, surface.degenerate_faces);
  EXPECT_EQ(diagnosis.duplicate_faces, surface.duplicate_faces);
  EXPECT_EQ(diagnosis.joined_edges, surface.joined_edges);
  EXPECT_EQ(diagnosis.matchable_area_share, surface.area / surface.total_area);
}

TEST_P(DiagnosisZoo, DuplicateVerticesMatchAPairwiseCount) {
  const std::vector<Point>& points = GetParam().mesh.vertices;
  int duplicates = 0;
  for (auto p = points.begin(); p != points.end(); ++p)
    duplicates += std::find(points.begin(), p, *p) != p;
  EXPECT_EQ(diagnose(GetParam().mesh).duplicate_vertices, duplicates);
}

TEST_P(DiagnosisZoo, UnitsDoNotMatter) {
  // Powers of two scale coordinates without rounding.
  const MeshDiagnosis small = diagnose(test::scaled(GetParam().mesh, 0x1p-100));
  const MeshDiagnosis large = diagnose(test::scaled(GetParam().mesh, 0x1p100));
  EXPECT_EQ(small.given, large.given);
  EXPECT_EQ(small.surface, large.surface);
  EXPECT_EQ(small.warnings(), large.warnings());
  EXPECT_EQ(small.max_edge * 0x1p200, large.max_edge);
}

TEST_P(DiagnosisZoo, RigidMotionsDoNotMatter) {
  test::Random random(3);
  const MeshDiagnosis a = diagnose(GetParam().mesh);
  const MeshDiagnosis b = diagnose(test::moved(GetParam().mesh, random));
  EXPECT_EQ(a.given, b.given);
  EXPECT_EQ(a.surface, b.surface);
  EXPECT_EQ(a.matchable_vertices, b.matchable_vertices);
  EXPECT_EQ(a.duplicate_vertices, b.duplicate_vertices);
  EXPECT_EQ(a.warnings(), b.warnings());
}

}  // namespace
}  // namespace isomatch
