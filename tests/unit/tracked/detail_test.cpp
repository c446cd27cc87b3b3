// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "support/context.h"
#include "support/shapes.h"
#include "tracked/simplify.h"

namespace isomatch::tracked {
namespace {

TEST(Simplify, KeepsSomeOfTheVerticesInOrder) {
  const Mesh mesh = test::rough_sphere(4, 0.1, 1);
  const SimplifiedMesh simplified = simplify(mesh, 300);
  EXPECT_NO_THROW(validate(simplified.mesh));
  EXPECT_NEAR(simplified.mesh.num_vertices(), 300, 10);
  EXPECT_TRUE(std::ranges::is_sorted(simplified.kept));
  for (int v = 0; v < simplified.mesh.num_vertices(); ++v)
    EXPECT_EQ(simplified.mesh.vertices[v], mesh.vertices[simplified.kept[v]]);
}

TEST(Simplify, LeavesASmallMeshAsItIs) {
  const Mesh mesh = test::icosphere(2);
  const SimplifiedMesh simplified = simplify(mesh, mesh.num_vertices());
  EXPECT_EQ(simplified.mesh.vertices, mesh.vertices);
  EXPECT_EQ(simplified.mesh.faces, mesh.faces);
}

class AttachedSphere : public testing::Test {
 protected:
  explicit AttachedSphere() {
    std::vector<int> all(detail_.mesh.vertices.size());
    std::iota(all.begin(), all.end(), 0);
    // A place that is linear in space tells where the vertices are attached.
    for (int d : all) detail_.features[d].place[0] = detail_.mesh.vertices[d].x();
  }

  UnitSurface surface_ = unit_surface(extract_surface(test::icosphere(5)));
  Detail detail_ = make_detail(surface_, 1000, {});
};

TEST_F(AttachedSphere, VerticesHaveAnchorsNearby) {
  const Attachment attachment = attach(surface_, detail_, {});
  ASSERT_EQ(attachment.anchors.size(), surface_.mesh.vertices.size());
  for (int v = 0; v < surface_.mesh.num_vertices(); ++v) {
    const Point& anchor = detail_.mesh.vertices[attachment.anchors[v]];
    EXPECT_LT((surface_.mesh.vertices[v] - anchor).norm(), 0.08);  // An edge is .03 on average.
  }
  for (std::size_t d = 0; d < detail_.surface_vertex.size(); ++d)
    EXPECT_EQ(attachment.anchors[detail_.surface_vertex[d]], d);
}

TEST_F(AttachedSphere, FeaturesAreInterpolated) {
  const Attachment attachment = attach(surface_, detail_, {});
  for (int v = 0; v < surface_.mesh.num_vertices(); ++v) {
    // Up to the edge of .03, where the closest face is not around the closest vertex.
    EXPECT_NEAR(attachment.features[v].place[0], surface_.mesh.vertices[v].x(), 0.03);
    // A sphere of unit area has the mean curvature 2 / .282; heat flow moves it by half of s^2 H.
    EXPECT_NEAR(attachment.features[v].relief[2], 0.06 * 2 / 0.2821, 0.05);
  }
}

TEST_F(AttachedSphere, ThreadsChangeNothing) {
  const Attachment one = attach(surface_, detail_, test::with_threads(1));
  const Attachment three = attach(surface_, detail_, test::with_threads(3));
  EXPECT_EQ(one.anchors, three.anchors);
  for (std::size_t v = 0; v < one.features.size(); ++v)
    EXPECT_EQ(one.features[v].relief, three.features[v].relief);
}

TEST(Attachment, ToADetailOfAllVerticesIsToThemselves) {
  const UnitSurface surface = unit_surface(extract_surface(test::rough_sphere(3, 0.2, 1)));
  const Detail detail = make_detail(surface, surface.mesh.num_vertices(), {});
  const Attachment attachment = attach(surface, detail, {});
  for (int v = 0; v < surface.mesh.num_vertices(); ++v) {
    EXPECT_EQ(attachment.anchors[v], v);
    EXPECT_EQ(attachment.features[v].relief, detail.features[v].relief);
  }
}

}  // namespace
}  // namespace isomatch::tracked
