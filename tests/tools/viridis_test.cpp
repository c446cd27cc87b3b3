// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/picture/viridis.h"

#include <gtest/gtest.h>

namespace isomatch::picture {
namespace {

float lightness(const Color& color) { return color.dot(Color(0.2126F, 0.7152F, 0.0722F)); }

/// Of matplotlib's table, which the polynomial meets within 4 of 255.
void expect_bytes(const Color& color, const Eigen::Vector3i& bytes) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(srgb_byte(color[k]), bytes[k], 4);
}

TEST(Viridis, HasTheColoursOfMatplotlib) {
  expect_bytes(viridis(0), {68, 1, 84});
  expect_bytes(viridis(0.5), {33, 145, 140});
  expect_bytes(viridis(1), {253, 231, 37});
}

TEST(Viridis, GetsLighterAllAlong) {
  for (int i = 0; i < 50; ++i)
    EXPECT_GT(lightness(viridis((i + 1) / 50.0)), lightness(viridis(i / 50.0)));
}

TEST(Viridis, StopsAtItsEnds) {
  EXPECT_EQ(viridis(-1), viridis(0));
  EXPECT_EQ(viridis(2), viridis(1));
}

}  // namespace
}  // namespace isomatch::picture
