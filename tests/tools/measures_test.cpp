// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "isomatch/io/map_file.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

namespace isomatch::results {
namespace {

TEST(Measures, UnmatchedVerticesHaveNoError) {
  const test::TemporaryFolder folder;
  const Mesh mesh = test::icosphere(2);
  VertexMap truth(10);
  for (int i = 0; i < 10; ++i) truth[i] = i;
  write_map(folder.path("truth.vts"), {.source_to_target = truth});

  MatchResult result;
  result.source = result.target = mesh;
  ResultMap map;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    map.source_to_target.push_back(v < 5 || v == 20 ? kUnmatched : v);
  map.points = corner_points(mesh, map.source_to_target);
  result.maps.push_back(map);
  const TruthFiles files{folder.path("truth.vts"), folder.path("truth.vts"), {}};
  const std::vector<double> error =
      measure_maps({result, {}, {}, Shapes{Shape(mesh), Shape(mesh)}}, files, {}).front().error;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    EXPECT_EQ(std::isnan(error[v]), map.source_to_target[v] == kUnmatched) << v;
}

}  // namespace
}  // namespace isomatch::results
