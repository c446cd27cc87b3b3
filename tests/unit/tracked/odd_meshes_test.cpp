// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <vector>

#include "isomatch/error.h"
#include "support/mesh_files.h"
#include "support/shapes.h"
#include "support/zoo.h"
#include "unit/tracked/matched_pair.h"

namespace isomatch {
namespace {

/// That a map or `InvalidInput` comes out, and nothing else.
void expect_map_or_refusal(const Mesh& a, const Mesh& b) {
  const Shape source(a), target(b);
  try {
    test::expect_sound(match_tracked(source, target), source, target);
    std::cout << "PROBE matched " << a.num_vertices() << " " << b.num_vertices() << "\n";
  } catch (const InvalidInput& error) {
    std::cout << "PROBE refused " << a.num_vertices() << " " << b.num_vertices() << " "
              << error.what() << "\n";
  }
}

TEST(Tracked, IsNotConfidentOfAShapeThatTurnsIntoItself) {
  const Shape sphere(test::icosphere(2));
  const TrackedResult result = match_tracked(sphere, sphere);
  test::expect_sound(result, sphere, sphere);
  EXPECT_GT(result.ambiguity, 0.9);
}

TEST(Tracked, MatchesOrRefusesTinyMeshes) {
  const Mesh triangle{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  const std::vector<Mesh> meshes{triangle,     test::tetrahedron(), test::sheet(1, 1),
                                 test::box(1), test::icosphere(0),  test::icosphere(1)};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (std::size_t j = 0; j < meshes.size(); ++j) {
      SCOPED_TRACE(std::to_string(i) + " onto " + std::to_string(j));
      expect_map_or_refusal(meshes[i], meshes[j]);
    }
  }
}

class TrackedZoo : public testing::TestWithParam<test::ZooMesh> {};

TEST_P(TrackedZoo, IsMatchedOrRefused) {
  expect_map_or_refusal(GetParam().mesh, test::icosphere(1));
  expect_map_or_refusal(test::torus(12, 6), GetParam().mesh);
}

INSTANTIATE_TEST_SUITE_P(Meshes, TrackedZoo, testing::ValuesIn(test::mesh_zoo()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace isomatch
