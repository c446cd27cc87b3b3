// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/geodesics/geodesics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "isomatch/error.h"
#include "support/random.h"
#include "support/rough_meshes.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kFloat = 1e-6;  ///< Rounding of sums of some ten floats, relative.

std::vector<float> field(const GeodesicGraph& graph, int source) {
  std::vector<float> distances(graph.num_vertices());
  GeodesicSearch(graph).field(source, distances);
  return distances;
}

std::vector<float> field(const Mesh& mesh, int source, const GeodesicOptions& options = {}) {
  return field(GeodesicGraph(mesh, options), source);
}

struct RelativeErrors {
  double least = 0, mean = 0, largest = 0;
};

/// Of `distances` against `exact`, a function of the vertex, over all vertices but `source`.
template <class Exact>
RelativeErrors relative_errors(const std::vector<float>& distances, int source,
                               const Exact& exact) {
  RelativeErrors errors;
  for (int v = 0; v < static_cast<int>(distances.size()); ++v) {
    if (v == source) continue;
    const double error = distances[v] / exact(v) - 1;
    errors.least = std::min(errors.least, error);
    errors.largest = std::max(errors.largest, error);
    errors.mean += error / static_cast<double>(distances.size() - 1);
  }
  return errors;
}

TEST(Geodesics, EdgesMeasureManhattanDistanceAlongTheAxesOfASheet) {
  const Mesh mesh = test::sheet(10, 10);
  const std::vector<float> distances = field(mesh, 0, GeodesicOptions::edges());
  EXPECT_NEAR(distances[10], 1, kFloat);
  EXPECT_NEAR(distances[10 * 11], 1, kFloat);
  EXPECT_EQ(distances[0], 0);
}

TEST(Geodesics, VisibleVerticesOfASheetAreSeenAlongStraightLines) {
  // Cells of 1 x 1: whatever the diagonals, the vertex a knight's move away is seen.
  const Mesh mesh = test::sheet(8, 8, 8, 8);
  const GeodesicGraph graph(mesh, GeodesicOptions::w10());
  GeodesicSearch search(graph);
  const int centre = 4 * 9 + 4;
  for (const int knight : {centre + 9 + 2, centre + 18 + 1, centre - 9 + 2, centre - 18 - 1})
    EXPECT_NEAR(search.distance(centre, knight), std::sqrt(5.0), kFloat);
}

TEST(Geodesics, PathsOnASheetAreNearlyStraight) {
  const Mesh mesh = test::sheet(30, 30);
  const auto straight = [&](int v) { return (mesh.vertices[v] - mesh.vertices[0]).norm(); };
  // A direction is at most half the window angle from an arc, so that a path of two arcs is at most
  // 1 / cos(angle / 2) too long: 1.6 % and .4 %.
  const RelativeErrors w20 = relative_errors(field(mesh, 0), 0, straight);
  const RelativeErrors w10 = relative_errors(field(mesh, 0, GeodesicOptions::w10()), 0, straight);
  EXPECT_GT(w20.least, -kFloat);
  EXPECT_LT(w20.largest, 0.016);
  EXPECT_GT(w10.least, -kFloat);
  EXPECT_LT(w10.largest, 0.004);
}

TEST(Geodesics, DistancesOnASphereAreThoseOfGreatCircles) {
  const Mesh mesh = test::icosphere(4);
  const auto arc = [&](int v) {
    return std::acos(std::clamp(mesh.vertices[0].dot(mesh.vertices[v]), -1.0, 1.0));
  };
  const RelativeErrors errors = relative_errors(field(mesh, 0), 0, arc);
  // The mesh lies inside the sphere: chords of .08 are shorter than their arcs by .08^2 / 24 = .03
  // %, across the flat of a triangle by up to four times that.
  EXPECT_GT(errors.least, -0.0012);
  EXPECT_LT(errors.mean, 0.003);
  EXPECT_LT(errors.largest, 0.016);
}

TEST(Geodesics, RollingASheetLeavesDistancesAsTheyAre) {
  const Mesh sheet = test::sheet(60, 20, 3, 1), rolled = test::rolled_sheet(60, 20, 3, 1, 5);
  const std::vector<float> flat = field(sheet, 700);
  // Chords of a circle of radius .6 that span 5 / 60 are shorter than the arc by .03 %; with the
  // same triangles everything else is equal.
  const RelativeErrors errors =
      relative_errors(field(rolled, 700), 700, [&](int v) { return flat[v]; });
  EXPECT_GT(errors.least, -0.0003 - kFloat);
  EXPECT_LT(errors.largest, kFloat);
}

TEST(Geodesics, PathsGoRoundASlit) {
  // A sheet of 20 x 20 cells without the cells of one row from the left edge to x = .75.
  Mesh mesh = test::sheet(20, 20);
  std::erase_if(mesh.faces, [&](const Face& face) {
    const Point centre =
        (mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]]) / 3;
    return centre.x() < 0.75 && centre.y() > 0.5 && centre.y() < 0.55;
  });
  const int below = 10 * 21, above = 11 * 21;
  const GeodesicGraph graph(mesh);
  // Along both banks, which are straight, and across the end.
  EXPECT_NEAR(GeodesicSearch(graph).distance(below, above), 0.75 + 0.05 + 0.75, 2 * kFloat);
}

TEST(Geodesics, ComponentsAreInfinitelyFarApart) {
  const Mesh mesh = test::combined(test::icosphere(1), test::icosphere(1, 0.5));
  const int n = mesh.num_vertices() / 2;
  const GeodesicGraph graph(mesh);
  const std::vector<float> distances = field(graph, 3);
  EXPECT_TRUE(std::all_of(distances.begin(), distances.begin() + n, [](float d) { return d < 4; }));
  EXPECT_EQ(std::count(distances.begin() + n, distances.end(), kInfinity), n);
  GeodesicSearch search(graph);
  EXPECT_EQ(search.distance(3, n + 3), kInfinity);
  EXPECT_EQ(search.ball(3, kInfinity).size(), n);
  const SourcePartition partition = search.nearest_source(std::array{3});
  EXPECT_EQ(partition.nearest[n], kNoSource);
  EXPECT_EQ(partition.distances[n], kInfinity);
}

TEST(Geodesics, AVertexOfNoFaceReachesOnlyItself) {
  const Mesh mesh = test::sphere_with_unreferenced_vertices();
  const GeodesicGraph graph(mesh);
  const std::vector<float> distances = field(graph, 0);
  EXPECT_EQ(distances[0], 0);
  EXPECT_EQ(std::ranges::count(distances, kInfinity), mesh.num_vertices() - 1);
}

TEST(Geodesics, StripsStopAtNonManifoldEdgesButPathsCross) {
  const Mesh mesh = test::three_sheets_on_a_line();
  const std::vector<float> distances = field(test::sheet(4, 4), 0);
  EXPECT_EQ(*std::ranges::max_element(distances), field(mesh, 0)[24]);
  // Two faces and a fin on their common edge: the diagonal is not seen, the way round is taken.
  Mesh fin{{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0), Point(0, 1, 1)},
           {{0, 1, 2}, {1, 3, 2}, {1, 2, 4}}};
  EXPECT_NEAR(field(fin, 0)[3], 2, kFloat);
  fin.faces.pop_back();
  EXPECT_NEAR(field(fin, 0)[3], std::numbers::sqrt2, kFloat);
}

TEST(Geodesics, OrientationOfFacesPlaysNoPart) {
  Mesh mesh = test::rough_torus(20, 10, 0.05, 1);
  const std::vector<float> expected = field(mesh, 5);
  for (int f = 0; f < mesh.num_faces(); f += 3) std::swap(mesh.faces[f][0], mesh.faces[f][2]);
  const std::vector<float> turned = field(mesh, 5);
  for (int v = 0; v < mesh.num_vertices(); ++v) EXPECT_NEAR(turned[v], expected[v], 5 * kFloat);
}

TEST(Geodesics, ANeedleIsCrossedStraight) {
  // A triangle of height 1e-7 between two halves of a unit square.
  const Mesh mesh{
      {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0.5 + 1e-7, 0.5, 0), Point(1, 1, 0)},
      {{0, 1, 3}, {0, 3, 2}, {3, 1, 4}, {3, 4, 2}}};
  EXPECT_NEAR(field(mesh, 0)[4], std::numbers::sqrt2, kFloat);
  EXPECT_NEAR(field(mesh, 1)[2], std::numbers::sqrt2, kFloat);
}

TEST(Geodesics, CoincidentVerticesAreAtDistanceZero) {
  Mesh mesh = test::sheet(6, 6);
  mesh.vertices[24] = mesh.vertices[25];
  const std::vector<float> distances = field(mesh, 25);
  EXPECT_EQ(distances[24], 0);
  const std::vector<float> from_other = field(mesh, 24);
  EXPECT_EQ(from_other[25], 0);
  // What is reached from one is reached from the other over the arc of no length.
  EXPECT_EQ(distances, from_other);
}

TEST(Geodesics, AMeshShrunkToAPointHasNoDistances) {
  Mesh mesh = test::icosphere(2);
  for (Point& p : mesh.vertices) p = Point(1, 2, 3);
  const GeodesicGraph graph(mesh);
  EXPECT_EQ(field(graph, 4), std::vector<float>(mesh.num_vertices(), 0.0F));
  EXPECT_EQ(GeodesicSearch(graph).ball(4, 0).size(), mesh.num_vertices());
  EXPECT_EQ(geodesic_diameter(graph), 0);
}

TEST(Geodesics, TinyAndHugeMeshesAreMeasuredInTheirOwnUnits) {
  const Mesh mesh = test::rough_sphere(2, 0.1, 1);
  const std::vector<float> unit = field(mesh, 0);
  for (const double scale : {0x1p-80, 0x1p80}) {
    const std::vector<float> distances = field(test::scaled(mesh, scale), 0);
    for (int v = 0; v < mesh.num_vertices(); ++v) ASSERT_EQ(distances[v] / scale, unit[v]);
  }
}

TEST(Geodesics, LongThinStripsEnd) {
  // Rings far apart and finely divided: a window crosses thousands of triangles.
  const Mesh mesh = test::open_cylinder(3000, 2, 1, 1000);
  const GeodesicGraph graph(mesh, GeodesicOptions::w10());
  EXPECT_LT(graph.num_arcs(), 200 * graph.num_vertices());
}

TEST(Geodesics, RejectsBadInput) {
  Mesh mesh = test::icosphere(1);
  EXPECT_THROW(GeodesicGraph(mesh, {GeodesicArcs::kVisibility, 0}), InvalidInput);
  EXPECT_THROW(GeodesicGraph(mesh, {GeodesicArcs::kVisibility, 61}), InvalidInput);
  EXPECT_THROW(GeodesicGraph(mesh, {GeodesicArcs::kVisibility, std::nan("")}), InvalidInput);
  EXPECT_THROW(GeodesicGraph(Mesh{}), InvalidInput);
  mesh.faces[7][1] = mesh.num_vertices();
  EXPECT_THROW(GeodesicGraph{mesh}, InvalidInput);
}

TEST(Geodesics, AStopIsHeeded) {
  std::stop_source stop;
  stop.request_stop();
  Context context;
  context.stop = stop.get_token();
  const Mesh mesh = test::icosphere(2);
  EXPECT_THROW(GeodesicGraph(mesh, {}, context), Cancelled);
  const GeodesicGraph graph(mesh);
  EXPECT_THROW(geodesic_fields(graph, std::array{0, 1}, context), Cancelled);
  EXPECT_THROW(geodesic_diameter(graph, context), Cancelled);
}

TEST(Geodesics, ThreadsChangeNothing) {
  const Mesh mesh = test::rough_sphere(4, 0.1, 2);  // Several blocks of the parallel loops.
  Context one, three;
  one.threads = 1;
  three.threads = 3;
  const GeodesicGraph a(mesh, {}, one), b(mesh, {}, three);
  ASSERT_EQ(a.num_arcs(), b.num_arcs());
  for (int v = 0; v < a.num_vertices(); ++v) {
    ASSERT_TRUE(std::ranges::equal(a.arcs(v), b.arcs(v), [](const auto& x, const auto& y) {
      return x.head == y.head && x.length == y.length;
    }));
  }
  const std::vector<int> sources{5, 900, 17, 33, 5};
  EXPECT_EQ(geodesic_fields(a, sources, one), geodesic_fields(a, sources, three));
  EXPECT_EQ(geodesic_diameter(a, one), geodesic_diameter(a, three));
}

TEST(Geodesics, FieldsAreRowsInTheOrderOfTheSources) {
  const GeodesicGraph graph(test::icosphere(2));
  const std::size_t n = graph.num_vertices();
  const std::vector<float> fields = geodesic_fields(graph, std::array{8, 2});
  ASSERT_EQ(fields.size(), 2 * n);
  EXPECT_EQ(std::vector(fields.begin(), fields.begin() + n), field(graph, 8));
  EXPECT_EQ(std::vector(fields.begin() + n, fields.end()), field(graph, 2));
}

/// From many sources fields are computed in bundles.
TEST(Geodesics, FieldsFromManySourcesAreThoseFromEach) {
  for (const auto& [name, mesh] : test::mesh_zoo()) {
    SCOPED_TRACE(name);
    const GeodesicGraph graph(mesh);
    const auto n = static_cast<std::size_t>(graph.num_vertices());
    std::vector<int> sources;
    for (std::size_t i = 0; i < 50; ++i) sources.push_back(static_cast<int>(i * 37 % n));
    const std::vector<float> fields = geodesic_fields(graph, sources);
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const auto row = fields.begin() + static_cast<std::ptrdiff_t>(i * n);
      ASSERT_EQ(std::vector(row, row + static_cast<std::ptrdiff_t>(n)), field(graph, sources[i]));
    }
  }
}

TEST(Geodesics, EveryMeshOfTheZooIsMeasured) {
  for (const auto& [name, mesh] : test::mesh_zoo()) {
    SCOPED_TRACE(name);
    const GeodesicGraph graph(mesh);
    const std::vector<float> distances = field(graph, 0);
    const std::vector<float> edges = field(mesh, 0, GeodesicOptions::edges());
    for (int v = 0; v < mesh.num_vertices(); ++v) {
      EXPECT_LE(distances[v], edges[v] * (1 + kFloat));
      EXPECT_GE(distances[v], (mesh.vertices[v] - mesh.vertices[0]).norm() * (1 - kFloat));
      EXPECT_EQ(distances[v] == kInfinity, edges[v] == kInfinity);
    }
  }
}

TEST(GeodesicDiameter, OfASphereIsHalfAGreatCircle) {
  // To the error of W20 in the direction of its paths, and of chords against arcs.
  EXPECT_NEAR(geodesic_diameter(GeodesicGraph(test::icosphere(4, 2))), 2 * std::numbers::pi, 0.06);
}

TEST(GeodesicDiameter, OfASheetIsItsDiagonal) {
  const GeodesicGraph graph(test::sheet(20, 20, 3, 4));
  EXPECT_NEAR(geodesic_diameter(graph), 5, 5 * 0.016);
}

TEST(GeodesicDiameter, IsTheLargestOfAllDistances) {
  const std::vector<Mesh> meshes{test::torus(40, 16),
                                 test::rough_sphere(3, 0.2, 3),
                                 test::rough_torus(40, 20, 0.1, 4),
                                 test::holed_terrain(24, 0.02, 5),
                                 test::box(8, Point(1, 2, 3)),
                                 test::closed_cylinder(20, 12)};
  for (const Mesh& mesh : meshes) {
    const GeodesicGraph graph(mesh);
    std::vector<int> all(mesh.num_vertices());
    std::iota(all.begin(), all.end(), 0);
    float largest = 0;
    for (const float d : geodesic_fields(graph, all))
      if (d < kInfinity) largest = std::max(largest, d);
    const double diameter = geodesic_diameter(graph);
    EXPECT_LE(diameter, largest);
    EXPECT_GE(diameter, 0.995 * largest);
  }
}

TEST(GeodesicDiameter, IsThatOfTheLargestComponent) {
  const double alone = geodesic_diameter(GeodesicGraph(test::icosphere(3)));
  Mesh mesh = test::combined(test::icosphere(2, 0.3), test::icosphere(3));
  mesh = test::combined(mesh, test::icosphere(2, 0.5));
  mesh.vertices.insert(mesh.vertices.end(), 20, Point(9, 9, 9));
  EXPECT_NEAR(geodesic_diameter(GeodesicGraph(mesh)), alone, 0.005 * alone);
}

}  // namespace
}  // namespace isomatch
