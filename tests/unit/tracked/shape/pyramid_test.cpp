// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>
#include <thread>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/mesh/synth.h"
#include "support/context.h"
#include "support/shapes.h"

namespace isomatch::tracked {
namespace {

constexpr PyramidOptions kSmall{.detail_vertices = 800,
                                .proxy = {.vertices = 500, .nodes = 150},
                                .coarse_nodes = 40,
                                .middle_nodes = 80,
                                .functions = 20};

class PyramidTest : public testing::Test {
 protected:
  const PreparedShape shape_{synthesize({.vertices = 2000, .pose = 1}).mesh, {}};
};

TEST_F(PyramidTest, IsMadeOnceAndKept) {
  const auto first = pyramid_of(shape_, {}, kSmall, {});
  EXPECT_EQ(pyramid_of(shape_, {}, kSmall, {}), first);
  const auto image = pyramid_of(shape_, {.mirrored = true}, kSmall, {});
  EXPECT_NE(image, first);
  EXPECT_TRUE(image->view.mirrored);
  PyramidOptions other = kSmall;
  other.functions = 10;
  EXPECT_NE(pyramid_of(shape_, {}, other, {}), first);
  EXPECT_EQ(pyramid_of(shape_, {.mirrored = true}, kSmall, {}), image);
  EXPECT_EQ(pyramid_of(shape_, {}, kSmall, {}), first);
}

TEST_F(PyramidTest, IsMadeOnceForAllThreads) {
  std::vector<std::shared_ptr<const Pyramid>> made(4);
  {
    std::vector<std::jthread> threads;
    for (auto& own : made)
      threads.emplace_back([&] { own = pyramid_of(shape_, {}, kSmall, test::with_threads(1)); });
  }
  for (const auto& own : made) EXPECT_EQ(own, made.front());
}

TEST_F(PyramidTest, IsMadeAgainAfterAStop) {
  std::stop_source stop;
  stop.request_stop();
  Context stopped;
  stopped.stop = stop.get_token();
  EXPECT_THROW(pyramid_of(shape_, {}, kSmall, stopped), Cancelled);
  EXPECT_NE(pyramid_of(shape_, {}, kSmall, {}), nullptr);
}

TEST_F(PyramidTest, GetsSmallerLevelByLevel) {
  const Pyramid pyramid = make_pyramid(shape_, {}, kSmall, {});
  EXPECT_EQ(pyramid.surface, shape_.surface());
  EXPECT_EQ(pyramid.anchors.size(), shape_.surface()->mesh.vertices.size());
  EXPECT_NEAR(pyramid.detail.mesh.num_vertices(), 800, 16);
  EXPECT_NEAR(pyramid.proxy.num_vertices(), 500, 10);
  EXPECT_EQ(pyramid.fine.size(), 150);
  EXPECT_EQ(pyramid.middle.size(), 80);
  EXPECT_EQ(pyramid.coarse.size(), 40);
  EXPECT_EQ(pyramid.basis.functions.cols(), 20);
}

TEST_F(PyramidTest, OfTheMirrorImageIsTheMirrorImage) {
  const Pyramid plain = make_pyramid(shape_, {}, kSmall, {});
  const Pyramid image = make_pyramid(shape_, {.mirrored = true}, kSmall, {});
  EXPECT_TRUE(image.proxy.oriented);
  ASSERT_EQ(image.surface->num_vertices(), plain.surface->num_vertices());
  for (int v = 0; v < plain.surface->num_vertices(); ++v) {
    const Point& p = plain.surface->mesh.vertices[v];
    EXPECT_EQ(image.surface->mesh.vertices[v], Point(-p.x(), p.y(), p.z()));
  }
}

TEST(Pyramid, OfASmallShapeSharesItsGeodesics) {
  const PreparedShape shape(test::rough_sphere(3, 0.1, 1), {});
  const Pyramid plain = make_pyramid(shape, {}, {}, {}),
                image = make_pyramid(shape, {.mirrored = true}, {}, {});
  EXPECT_EQ(plain.detail.graph, shape.graph({}, {}));
  EXPECT_EQ(plain.proxy.graph, plain.detail.graph);
  EXPECT_EQ(image.detail.graph, plain.detail.graph);
}

}  // namespace
}  // namespace isomatch::tracked
