// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/context.h"
#include "support/shapes.h"

namespace isomatch::tracked {
namespace {

class DetailOfASphere : public testing::Test {
 protected:
  const PreparedShape shape_{test::icosphere(5), {}};
  const Surface& surface_ = *shape_.surface();
  const Detail detail_ = make_detail(shape_, surface_, {.detail_vertices = 1000}, {});
};

TEST_F(DetailOfASphere, HasItsRelief) {
  // A sphere of unit area has a mean curvature of 2 / .282, and heat flow over s moves it by s^2 of
  // that, up to a hundredth for the triangles being flat.
  for (const elastic::Features& features : detail_.features)
    EXPECT_NEAR(features.relief[2], 0.06 * 2 / 0.2821, 0.05);
}

TEST_F(DetailOfASphere, IsNearEveryVertex) {
  const std::vector<int> anchor = anchors(surface_, detail_, {});
  ASSERT_EQ(anchor.size(), surface_.mesh.vertices.size());
  for (int v = 0; v < surface_.mesh.num_vertices(); ++v) {
    const Point& p = detail_.mesh.vertices[anchor[v]];
    EXPECT_LT((surface_.mesh.vertices[v] - p).norm(), 0.05);  // An edge is .03 on average.
  }
  for (std::size_t d = 0; d < detail_.surface_vertex.size(); ++d)
    EXPECT_EQ(anchor[detail_.surface_vertex[d]], d);
}

TEST_F(DetailOfASphere, ThreadsChangeNothing) {
  EXPECT_EQ(anchors(surface_, detail_, test::with_threads(1)),
            anchors(surface_, detail_, test::with_threads(3)));
}

TEST(Detail, OfASmallSurfaceIsTheSurface) {
  const PreparedShape shape(test::rough_sphere(3, 0.2, 1), {});
  const Surface& surface = *shape.surface();
  const Detail detail =
      make_detail(shape, surface, {.detail_vertices = surface.num_vertices()}, {});
  EXPECT_EQ(detail.mesh.vertices, surface.mesh.vertices);
  const std::vector<int> anchor = anchors(surface, detail, {});
  for (int v = 0; v < surface.mesh.num_vertices(); ++v) EXPECT_EQ(anchor[v], v);
}

}  // namespace
}  // namespace isomatch::tracked
