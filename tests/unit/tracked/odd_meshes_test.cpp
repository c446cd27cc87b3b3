// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "isomatch/error.h"
#include "shape/boundary.h"
#include "shape/prepared_shape.h"
#include "support/mesh_files.h"
#include "support/shapes.h"
#include "support/zoo.h"
#include "tracked/options.h"
#include "unit/tracked/matched_pair.h"

namespace isomatch {
namespace {

/// Whether so little of it is boundary that nothing is missing.
bool is_whole(const Shape& shape) {
  return boundary_length(shape.prepared().surface()->mesh) <=
         tracked::PartialOptions{}.open_boundary;
}

/// Vertices may be left out if something may be missing of one of the shapes.
void expect_matched(const Mesh& a, const Mesh& b) {
  const Shape source(a), target(b);
  const TrackedResult result = match_tracked(source, target);
  if (is_whole(source) && is_whole(target))
    test::expect_sound(result, source, target);
  else
    test::expect_sound_parts(result, source, target);
}

/// That the map is not empty, whatever is missing.
void expect_matched_to_itself(const Mesh& mesh) {
  expect_matched(mesh, mesh);
  const Shape shape(mesh);
  const TrackedResult result = match_tracked(shape, shape);
  EXPECT_FALSE(matches(shape, shape, result.maps.front()).empty());
}

void expect_refused(const Mesh& a, const Mesh& b) {
  try {
    match_tracked(Shape(a), Shape(b));
    ADD_FAILURE() << "it is matched";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "the shapes have too little in common: there is no hypothesis to follow");
  }
}

TEST(Tracked, IsNotConfidentOfAShapeThatTurnsIntoItself) {
  const Shape sphere(test::icosphere(2));
  const TrackedResult result = match_tracked(sphere, sphere);
  test::expect_sound(result, sphere, sphere);
  EXPECT_GT(result.ambiguity, 0.9);
}

/// Of three and four vertices.
std::vector<Mesh> smallest_meshes() {
  return {{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}}, test::tetrahedron(), test::sheet(1, 1)};
}

std::vector<Mesh> small_meshes() { return {test::box(1), test::icosphere(0), test::icosphere(1)}; }

TEST(Tracked, MatchesTheSmallestMeshesToThemselves) {
  for (const Mesh& mesh : smallest_meshes()) {
    SCOPED_TRACE(mesh.num_vertices());
    expect_matched_to_itself(mesh);
  }
}

TEST(Tracked, RefusesTheSmallestMeshesOntoOthers) {
  const std::vector<Mesh> meshes = smallest_meshes();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (std::size_t j = 0; j < meshes.size(); ++j) {
      SCOPED_TRACE(std::to_string(i) + " onto " + std::to_string(j));
      if (i != j) expect_refused(meshes[i], meshes[j]);
    }
    for (const Mesh& other : small_meshes()) {
      SCOPED_TRACE(std::to_string(i) + " and " + std::to_string(other.num_vertices()));
      expect_refused(meshes[i], other);
      expect_refused(other, meshes[i]);
    }
  }
}

TEST(Tracked, MatchesMeshesOfAFewVertices) {
  for (const Mesh& source : small_meshes()) {
    for (const Mesh& target : small_meshes()) {
      SCOPED_TRACE(std::to_string(source.num_vertices()) + " onto " +
                   std::to_string(target.num_vertices()));
      expect_matched(source, target);
    }
  }
}

class TrackedZoo : public testing::TestWithParam<test::ZooMesh> {};

TEST_P(TrackedZoo, IsMatched) {
  expect_matched(GetParam().mesh, test::icosphere(1));
  expect_matched(test::torus(12, 6), GetParam().mesh);
}

INSTANTIATE_TEST_SUITE_P(Meshes, TrackedZoo, testing::ValuesIn(test::mesh_zoo()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace isomatch
