// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/picture/canvas.h"

#include <gtest/gtest.h>

#include "isomatch/error.h"
#include "results/picture/pair.h"
#include "support/shapes.h"

namespace isomatch::picture {
namespace {

const Color kRed{1, 0, 0}, kGreen{0, 1, 0}, kBlack{0, 0, 0};

Mesh triangle(const Point& a, const Point& b, const Point& c) { return {{a, b, c}, {{0, 1, 2}}}; }

std::vector<Color> uniform(const Mesh& mesh, const Color& color) {
  return std::vector<Color>(mesh.vertices.size(), color);
}

/// One unit a pixel, the origin at the lower left.
Projection pixels(int height) {
  Projection projection;
  projection.centre = {0, height};
  return projection;
}

double sum_of_red(const Image& image) {
  double sum = 0;
  for (const Color& pixel : image.pixels) sum += pixel[0];
  return sum;
}

TEST(Canvas, CoversTheAreaOfATriangle) {
  const Mesh mesh = triangle({3, 2, 0}, {43, 7, 0}, {11, 33, 0});
  Canvas canvas(50, 40, kBlack);
  canvas.draw(mesh, uniform(mesh, kRed), pixels(40));
  const Image image = canvas.image();
  const double lit = image.at(19, 26)[0];
  // The boundary of about 115 pixels is sampled to a third of a pixel with no bias.
  EXPECT_NEAR(sum_of_red(image) / lit, surface_area(mesh), 3);
  EXPECT_EQ(image.at(0, 0), kBlack);
}

/// Two triangles that cover a square of 40 pixels with a whole image.
TexturePaint whole_image(const Mesh& square, const Image& image) {
  TexturePaint paint{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, square.faces, {"image"}, {0, 0}}, {image}};
  return paint;
}

const Mesh kSquare{{{0, 0, 0}, {40, 0, 0}, {40, 40, 0}, {0, 40, 0}}, {{0, 1, 2}, {0, 2, 3}}};

TEST(Canvas, ATexturesImageStandsUpright) {
  const Color blue{0, 0, 1};
  Canvas canvas(40, 40, kBlack);
  canvas.draw(kSquare, whole_image(kSquare, {2, 2, {kRed, kGreen, blue, kBlack}}), pixels(40));
  const Image image = canvas.image();
  // In the middle of each of the four pixels, up to the light.
  EXPECT_TRUE(image.at(10, 10).normalized().isApprox(kRed, 0.05F));
  EXPECT_TRUE(image.at(30, 10).normalized().isApprox(kGreen, 0.05F));
  EXPECT_TRUE(image.at(10, 30).normalized().isApprox(blue, 0.05F));
  EXPECT_LT(image.at(30, 30).norm(), 0.1F);
}

TEST(Canvas, WithoutAnImageThereIsACheckerboard) {
  Canvas canvas(40, 40, kBlack);
  canvas.draw(kSquare, whole_image(kSquare, {}), pixels(40));
  const Image image = canvas.image();
  // Squares of five pixels.
  EXPECT_GT((image.at(2, 2) - image.at(7, 2)).norm(), 0.1F);
  EXPECT_LT((image.at(2, 2) - image.at(3, 3)).norm(), 0.1F);
}

TEST(Canvas, FacesWithoutTextureAreGrey) {
  TexturePaint paint = whole_image(kSquare, {1, 1, {kRed}});
  paint.texture.corners[1].fill(Texture::kNone);
  paint.texture.face_material[1] = Texture::kNone;
  Canvas canvas(40, 40, kBlack);
  canvas.draw(kSquare, paint, pixels(40));
  const Image image = canvas.image();
  EXPECT_EQ(image.at(30, 35)[1], 0);
  EXPECT_NEAR(image.at(10, 5)[0], image.at(10, 5)[1], 0.05F);
  EXPECT_GT(image.at(10, 5)[1], 0);
}

TEST(Canvas, EdgesAreSmooth) {
  const Mesh mesh = triangle({0, 0, 0}, {40, 13, 0}, {0, 39, 0});
  Canvas canvas(40, 40, kBlack);
  canvas.draw(mesh, uniform(mesh, kRed), pixels(40));
  const Image image = canvas.image();
  const float full = image.at(3, 20)[0];
  int between = 0;
  for (const Color& pixel : image.pixels) between += pixel[0] > 0 && pixel[0] < 0.95F * full;
  EXPECT_GT(between, 30);
}

TEST(Canvas, NeighboursShareNoSampleAndLeaveNoGap) {
  const Mesh sheet = test::sheet(7, 5, 30, 20);
  Canvas canvas(30, 20, kBlack);
  canvas.draw(sheet, uniform(sheet, kRed), pixels(20));
  const Image image = canvas.image();
  for (const Color& pixel : image.pixels) EXPECT_NEAR(pixel[0], image.at(15, 10)[0], 1e-5);
}

TEST(Canvas, TheNearerOneIsInFrontWhateverTheOrder) {
  const Mesh near = triangle({0, 0, 1}, {20, 0, 1}, {0, 20, 1});
  const Mesh far = triangle({0, 0, 0}, {20, 0, 0}, {0, 20, 0});
  for (const bool near_first : {true, false}) {
    Canvas canvas(20, 20, kBlack);
    if (near_first) canvas.draw(near, uniform(near, kRed), pixels(20));
    canvas.draw(far, uniform(far, kGreen), pixels(20));
    if (!near_first) canvas.draw(near, uniform(near, kRed), pixels(20));
    const Color pixel = canvas.image().at(4, 15);
    EXPECT_GT(pixel[0], 0.5F);
    EXPECT_EQ(pixel[1], 0);
  }
}

TEST(Canvas, InterpolatesColours) {
  const Mesh mesh = triangle({0, 0, 0}, {60, 0, 0}, {0, 60, 0});
  Canvas canvas(60, 60, kBlack);
  canvas.draw(mesh, std::vector<Color>{kBlack, kRed, kGreen}, pixels(60));
  const Image image = canvas.image();
  EXPECT_NEAR(image.at(20, 39)[0], image.at(20, 39)[1], 0.02);
  EXPECT_GT(image.at(50, 57)[0], 4 * image.at(50, 57)[1]);
}

TEST(Canvas, TheBackOfAFaceLooksLikeItsFront) {
  const Mesh front = triangle({0, 0, 0}, {20, 0, 3}, {0, 20, 1});
  const Mesh back = triangle({0, 0, 0}, {0, 20, 1}, {20, 0, 3});
  Canvas a(20, 20, kBlack), b(20, 20, kBlack);
  a.draw(front, uniform(front, kRed), pixels(20));
  b.draw(back, uniform(back, kRed), pixels(20));
  EXPECT_NEAR(a.image().at(5, 14)[0], b.image().at(5, 14)[0], 1e-5);
}

TEST(Canvas, FacesWithoutAreaOrOutsideDoNoHarm) {
  const Mesh mesh{{{5, 5, 0}, {5, 5, 0}, {9, 9, 0}, {-1e9, 3, 0}, {1e9, 4, 0}, {3, 1e9, 0}},
                  {{0, 1, 2}, {0, 0, 2}, {3, 4, 5}}};
  Canvas canvas(10, 10, kBlack);
  EXPECT_NO_THROW(canvas.draw(mesh, uniform(mesh, kRed), pixels(10)));
}

TEST(Canvas, RefusesWhatDoesNotFit) {
  EXPECT_THROW(Canvas(0, 5, kBlack), InvalidInput);
  EXPECT_THROW(Canvas(5, 20001, kBlack), InvalidInput);
  Canvas canvas(5, 5, kBlack);
  const Mesh mesh = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_THROW(canvas.draw(mesh, std::vector<Color>(2), pixels(5)), InvalidInput);
}

/// Columns of `image` in which something is drawn, from `first` to `last`.
int drawn_columns(const Image& image, int first, int last) {
  int count = 0;
  for (int x = first; x < last; ++x) {
    bool drawn = false;
    for (int y = 0; y < image.height; ++y) drawn |= image.at(x, y) != kBlack;
    count += drawn;
  }
  return count;
}

TEST(DrawPair, ShowsShapesOfAnyUnitAtTheSameSize) {
  const Mesh small = test::icosphere(3, 0.01), large = test::icosphere(3, 500);
  const Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  const Image image = draw_pair({small, uniform(small, kRed), rotation},
                                {large, uniform(large, kRed), rotation}, 400, kBlack);
  EXPECT_EQ(image.width, 400);
  EXPECT_LE(image.height, 400);
  const int left = drawn_columns(image, 0, 200), right = drawn_columns(image, 200, 400);
  EXPECT_NEAR(left, right, 1);
  EXPECT_GT(left, 150);
  EXPECT_EQ(drawn_columns(image, 0, 5) + drawn_columns(image, 198, 202), 0);
}

}  // namespace
}  // namespace isomatch::picture
