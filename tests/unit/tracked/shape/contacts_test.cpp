// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/handle_loop.h"
#include "support/shapes.h"
#include "unit/tracked/prepared.h"

namespace isomatch::tracked {
namespace {

using test::Prepared;

/// A ring that is thinner near the positive x axis, in a valley, as where a hand is fused to a hip.
Mesh fused_ring(double depth) {
  constexpr double kMajor = 1, kMinor = 0.12, kWidth = 0.06;
  Mesh mesh = test::torus(200, 32, kMajor, kMinor);
  for (Point& p : mesh.vertices) {
    const double angle = std::atan2(p.y(), p.x());
    const Point axis(kMajor * std::cos(angle), kMajor * std::sin(angle), 0);
    p = axis + (1 - depth * std::exp(-std::pow(angle / kWidth, 2))) * (p - axis);
  }
  return mesh;
}

int num_handles(const Detail& detail) {
  return HandleLoops(detail.mesh, std::vector<double>(detail.mesh.vertices.size(), 1.0))
      .num_handles();
}

TEST(Contacts, AreWhereAHandleIsInAValley) {
  const Mesh mesh = fused_ring(0.6);
  const Prepared ring(mesh);
  const std::vector<Cut> cuts = possible_cuts(ring.detail, {}, {});
  ASSERT_FALSE(cuts.empty());
  EXPECT_TRUE(std::ranges::is_sorted(cuts.front()));
  for (const int v : cuts.front()) {
    const Point& p = mesh.vertices[ring.surface.input_vertex[v]];
    EXPECT_LT(std::abs(std::atan2(p.y(), p.x())), 0.05);
  }
  const Detail apart = without(ring.detail, cuts.front(), {});
  EXPECT_EQ(num_handles(ring.detail), 1);
  EXPECT_EQ(num_handles(apart), 0);
}

TEST(Contacts, HandlesWithoutAValleyStayClosed) {
  EXPECT_TRUE(possible_cuts(Prepared(fused_ring(0)).detail, {}, {}).empty());
}

TEST(Contacts, ShapesWithoutHandlesHaveNone) {
  EXPECT_TRUE(possible_cuts(Prepared(test::box(8)).detail, {}, {}).empty());
}

TEST(Contacts, ADetailWithoutACutKeepsTheRest) {
  const Prepared ring(fused_ring(0.6));
  const Cut cut{3, 50, 51};
  const Detail apart = without(ring.detail, cut, {});
  EXPECT_EQ(apart.mesh.num_vertices(), ring.detail.mesh.num_vertices() - 3);
  EXPECT_EQ(apart.faces.size(), apart.mesh.num_vertices());
  for (int d = 0; d < apart.mesh.num_vertices(); ++d) {
    const int v = apart.surface_vertex[d];
    EXPECT_FALSE(std::ranges::binary_search(cut, v));
    EXPECT_EQ(apart.mesh.vertices[d], ring.surface.mesh.vertices[v]);
    EXPECT_EQ(apart.features[d].relief, ring.detail.features[v].relief);
  }
}

TEST(Contacts, CutsAreUnited) {
  EXPECT_EQ(united({1, 4, 9}, {2, 4}), (Cut{1, 2, 4, 9}));
  EXPECT_EQ(united({}, {2, 4}), (Cut{2, 4}));
}

}  // namespace
}  // namespace isomatch::tracked
