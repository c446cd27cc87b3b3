// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <string>
#include <utility>
#include <vector>

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
using testing::HasSubstr;

template <class From, class To>
constexpr bool kConverts = std::convertible_to<From, To>;

static_assert(!kConverts<SurfaceMatches, Correspondence>);
static_assert(!kConverts<Correspondence, SurfaceMatches>);
static_assert(!kConverts<SurfacePoints, SurfaceMap>);
static_assert(!kConverts<SurfaceMap, SurfacePoints>);
static_assert(!kConverts<SurfaceVertices, std::vector<int>>);
static_assert(!kConverts<std::vector<int>, SurfaceVertices>);

/// All that may come between numbers: a small component before the sphere, faces that are turned,
/// seams, and vertices that no face uses, before and after.
Mesh jumbled_sphere() {
  Mesh sphere = test::rough_sphere(2, 0.2, 1);
  for (int f = 0; f < sphere.num_faces(); f += 7) std::swap(sphere.faces[f][0], sphere.faces[f][2]);
  Mesh mesh = test::combined(test::scaled(test::icosphere(1), 0.1),
                             test::split_charts(sphere, test::octants(sphere)));
  mesh.vertices.insert(mesh.vertices.begin(), {Point(3, 3, 3), Point(4, 4, 4)});
  for (Face& face : mesh.faces)
    for (int& v : face) v += 2;
  mesh.vertices.emplace_back(5, 5, 5);
  return mesh;
}

Surface surface_of(const Mesh& mesh) { return unit_surface(extract_surface(mesh)); }

std::vector<test::ZooMesh> meshes() {
  std::vector<test::ZooMesh> meshes = test::mesh_zoo();
  meshes.push_back({"jumbled_sphere", jumbled_sphere()});
  meshes.push_back({"loose_triangles", test::soup(test::icosphere(1))});
  meshes.push_back({"uv_sphere_far_away", test::scaled(test::uv_sphere(12, 6), 1e20)});
  return meshes;
}

/// From a mesh to the jumbled sphere, and back.
class Numbers : public testing::TestWithParam<test::ZooMesh> {
 protected:
  template <class Check>
  void both_ways(const Check& check) {
    check(mesh_, surface_, other_mesh_, other_);
    check(other_mesh_, other_, mesh_, surface_);
  }

  const Mesh mesh_ = GetParam().mesh, other_mesh_ = jumbled_sphere();
  const Surface surface_ = surface_of(mesh_), other_ = surface_of(other_mesh_);
  test::Random random_{3};
};

SurfacePoint random_point(const Mesh& mesh, test::Random& random) {
  const double a = random.uniform(), b = (1 - a) * random.uniform();
  return {random.index(mesh.num_faces()), {a, b, 1 - a - b}};
}

TEST_P(Numbers, MatchesComeBackAndHaveAllCopies) {
  both_ways([&](const Mesh&, const Surface& from, const Mesh&, const Surface& onto) {
    Correspondence given;
    std::size_t copies = 0;
    for (int v = 0; v < from.num_vertices(); ++v) {
      given.push_back({v, random_.index(onto.num_vertices())});
      copies += from.input_vertices[v].size() * onto.input_vertices[given.back().target].size();
    }
    const Correspondence input = to_input(from, onto, SurfaceMatches(given));
    EXPECT_EQ(input.size(), copies);
    EXPECT_TRUE(std::ranges::is_sorted(input));
    EXPECT_EQ(std::ranges::adjacent_find(input), input.end());
    for (const auto& [s, t] : input)
      EXPECT_EQ(given[from.surface_vertex[s]].target, onto.surface_vertex[t]);
    EXPECT_EQ(*on_surfaces(from, onto, input), given);
  });
}

TEST_P(Numbers, PointsStayWhereTheyAreAndComeBack) {
  both_ways([&](const Mesh&, const Surface& from, const Mesh& onto_mesh, const Surface& onto) {
    SurfaceMap given(from.num_vertices());
    for (std::size_t v = 0; v < given.size(); ++v)
      if (v % 7 != 6) given[v] = random_point(onto.mesh, random_);
    const SurfaceMap input = to_input(from, onto, SurfacePoints(given));
    ASSERT_EQ(input.size(), from.surface_vertex.size());
    for (std::size_t i = 0; i < input.size(); ++i) {
      const int v = from.surface_vertex[i];
      const bool known = v != kNoVertex && given[v].face != kNoFace;
      ASSERT_EQ(input[i].face != kNoFace, known);
      if (!known) continue;
      const Point expected = onto.scale * position(onto.mesh, given[v]) + onto.centre;
      // Scaling and moving round coordinates of the size of the shape.
      EXPECT_LT((position(onto_mesh, input[i]) - expected).norm(),
                1e-14 * (onto.scale + onto.centre.norm()));
    }
    EXPECT_EQ(*on_surfaces(from, onto, input), given);
  });
}

TEST_P(Numbers, OfAMirrorImageLeadToTheSamePoints) {
  const Surface image = mirror_image(surface_);
  const SurfacePoints given(SurfaceMap(surface_.num_vertices(), {0, {0.5, 0.3, 0.2}}));
  for (const SurfacePoint& point : to_input(surface_, image, given)) {
    if (point.face == kNoFace) continue;
    Point expected = position(image.mesh, given->front());
    expected.x() = -expected.x();
    expected = surface_.scale * expected + surface_.centre;
    EXPECT_LT((position(mesh_, point) - expected).norm(),
              1e-14 * (surface_.scale + surface_.centre.norm()));
  }
  EXPECT_EQ(*on_surfaces(surface_, image, to_input(surface_, image, given)), *given);
}

TEST_P(Numbers, VerticesComeBack) {
  const std::vector<int> given = random_.permutation(surface_.num_vertices());
  const std::vector<int> input = to_input(surface_, SurfaceVertices(given));
  for (std::size_t i = 0; i < given.size(); ++i)
    EXPECT_EQ(input[i], surface_.input_vertices[given[i]].front());
  EXPECT_EQ(*on_surface(surface_, input, "vertex"), given);
}

TEST_P(Numbers, ValuesAreThoseOfTheVertexAtThePlace) {
  std::vector<int> values(surface_.num_vertices());
  for (int v = 0; v < surface_.num_vertices(); ++v) values[v] = 10 + v;
  const std::vector<int> input = at_input(surface_, values, -7);
  ASSERT_EQ(input.size(), mesh_.vertices.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    const int v = surface_.surface_vertex[i];
    EXPECT_EQ(input[i], v == kNoVertex ? -7 : 10 + v);
  }
}

TEST_P(Numbers, PositionsOfAMovedSurfaceMoveTheWholeMesh) {
  // Coordinates are around the size of the shape.
  const Point shift = surface_.scale * Point(1, 2, 3);
  std::vector<Point> positions;
  for (int v : surface_.input_vertex) positions.emplace_back(mesh_.vertices[v] + shift);
  const std::vector<Point> input = at_input(mesh_, surface_, positions);
  ASSERT_EQ(input.size(), mesh_.vertices.size());
  for (std::size_t i = 0; i < input.size(); ++i)
    EXPECT_LT((input[i] - mesh_.vertices[i] - shift).norm(), 1e-13 * surface_.scale);
}

INSTANTIATE_TEST_SUITE_P(All, Numbers, testing::ValuesIn(meshes()),
                         [](const auto& test) { return test.param.name; });

/// Numbers of the jumbled sphere: one vertex off the surface, two copies at a seam, one that is
/// alone; and a face off the surface.
class JumbledNumbers : public testing::Test {
 protected:
  /// A vertex with or without another one at its place.
  int vertex_at(bool seam) const {
    for (int v = 0; v < surface_.num_vertices(); ++v)
      if ((surface_.input_vertices[v].size() > 1) == seam) return surface_.input_vertex[v];
    return kNoVertex;
  }

  /// That what is done throws, and says so.
  template <class Action>
  static void expect_invalid(const Action& action, const std::string& message) {
    try {
      action();
      ADD_FAILURE() << "no exception for '" << message << "'";
    } catch (const InvalidInput& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }

  const Mesh mesh_ = jumbled_sphere();
  const Surface surface_ = surface_of(mesh_);
  const int vertices_ = mesh_.num_vertices();
  const int alone_ = vertex_at(false), first_ = vertex_at(true);
  const int copy_ = surface_.input_vertices[surface_.surface_vertex[first_]].back();
  const int own_ = surface_.surface_vertex[alone_], shared_ = surface_.surface_vertex[first_];
};

TEST_F(JumbledNumbers, OfAVertex) {
  EXPECT_EQ(surface_vertex(surface_, 0), kNoVertex);
  EXPECT_EQ(surface_vertex(surface_, first_), shared_);
  EXPECT_EQ(surface_vertex(surface_, copy_), shared_);
  expect_invalid([&] { surface_vertex(surface_, -1); }, "vertex -1 is out of range");
  expect_invalid([&] { surface_vertex(surface_, vertices_); }, "is out of range");
}

TEST_F(JumbledNumbers, MatchesOffTheSurfaceAreLeftOutAndCopiesCountOnce) {
  const Correspondence given{{copy_, alone_},  {first_, alone_}, {0, alone_},     {alone_, 0},
                             {alone_, first_}, {alone_, copy_},  {first_, alone_}};
  Correspondence expected{{shared_, own_}, {own_, shared_}};
  std::ranges::sort(expected);
  EXPECT_EQ(*on_surfaces(surface_, surface_, given), expected);
}

TEST_F(JumbledNumbers, OfCopiesTheLowestHasThePoint) {
  SurfaceMap given(mesh_.vertices.size());
  const int face = surface_.input_face[3], other = surface_.input_face[4];
  given[first_] = {face, {0.5, 0.25, 0.25}};
  given[copy_] = {other, {0.5, 0.25, 0.25}};
  EXPECT_EQ((*on_surfaces(surface_, surface_, given))[shared_].face, 3);
  given[first_] = {};
  EXPECT_EQ((*on_surfaces(surface_, surface_, given))[shared_], SurfacePoint{});
}

TEST_F(JumbledNumbers, PointsOffTheSurfaceAreNone) {
  // The faces of the small component come first.
  const SurfaceMap given(mesh_.vertices.size(), {0, {1, 0, 0}});
  EXPECT_THAT(*on_surfaces(surface_, surface_, given), Each(SurfacePoint{}));
}

TEST_F(JumbledNumbers, MatchesOutOfRangeThrow) {
  for (const Match& match : {Match{-1, alone_},
                             {alone_, -1},
                             {vertices_, alone_},
                             {alone_, vertices_},
                             {0, vertices_},
                             {vertices_, 0}})
    expect_invalid([&] { on_surfaces(surface_, surface_, Correspondence{match}); }, "out of range");
}

TEST_F(JumbledNumbers, MapsThatDoNotFitThrow) {
  const auto expect_rejected = [&](const SurfaceMap& map, const std::string& message) {
    expect_invalid([&] { on_surfaces(surface_, surface_, map); }, message);
  };
  expect_rejected(SurfaceMap(mesh_.vertices.size() - 1), "points, but the mesh");
  expect_rejected(SurfaceMap(surface_.mesh.vertices.size()), "points, but the mesh");
  // Whatever the vertex: on the surface, the second of two copies, off the surface.
  for (const int vertex : {alone_, copy_, 0}) {
    SurfaceMap map(mesh_.vertices.size());
    map[vertex] = {-2, {1, 0, 0}};
    expect_rejected(map, "face -2");
    map[vertex] = {mesh_.num_faces(), {1, 0, 0}};
    expect_rejected(map, "face " + std::to_string(mesh_.num_faces()));
    map[vertex].face = mesh_.num_faces() - 1;
    EXPECT_NO_THROW(on_surfaces(surface_, surface_, map));
  }
}

TEST_F(JumbledNumbers, VerticesThatHaveToBeOnTheSurface) {
  EXPECT_THAT(*on_surface(surface_, std::vector{copy_, alone_, first_}, "vertex"),
              ElementsAre(shared_, own_, shared_));
  const auto expect_rejected = [&](int vertex, const std::string& message) {
    expect_invalid(
        [&] {
          on_surface(surface_, std::vector{alone_, vertex}, "the order's vertex");
        },
        message);
  };
  expect_rejected(-1, "the order's vertex -1 is out of range");
  expect_rejected(vertices_, "is out of range");
  expect_rejected(0, "the order's vertex 0 is not on the surface that is matched");
}

TEST_F(JumbledNumbers, NoVertexStaysNone) {
  EXPECT_THAT(to_input(surface_, SurfaceVertices({own_, kUnmatched, shared_})),
              ElementsAre(alone_, kUnmatched, first_));
}

TEST(PositionsAtInput, OthersMoveAndTurnWithTheSurface) {
  Mesh mesh = test::sheet(2, 2, 2, 2);
  // One over the corner (2, 2), one beside the corner (0, 0).
  mesh.vertices.insert(mesh.vertices.begin(), {Point(2.1, 2.2, 1), Point(-0.5, 0, -1)});
  for (Face& face : mesh.faces)
    for (int& v : face) v += 2;
  const Surface surface = surface_of(mesh);
  const auto motion = [](const Point& p) { return Point(1 - p.y(), 2 + p.x(), 3 + p.z()); };
  std::vector<Point> positions;
  for (int v : surface.input_vertex) positions.push_back(motion(mesh.vertices[v]));
  const std::vector<Point> moved = at_input(mesh, surface, positions);
  for (int v = 0; v < 2; ++v) EXPECT_TRUE(moved[v].isApprox(motion(mesh.vertices[v]), 1e-9));
  for (int v = 2; v < mesh.num_vertices(); ++v)
    EXPECT_EQ(moved[v], positions[surface.surface_vertex[v]]);
}

}  // namespace
}  // namespace isomatch
