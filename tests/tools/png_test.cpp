// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>
#include <png.h>

#include "isomatch/error.h"
#include "results/picture/image.h"
#include "support/temporary_folder.h"

namespace isomatch::picture {
namespace {

TEST(Png, BytesAreThoseOfSrgb) {
  EXPECT_EQ(srgb_byte(0), 0);
  EXPECT_EQ(srgb_byte(1), 255);
  EXPECT_EQ(srgb_byte(-3), 0);
  EXPECT_EQ(srgb_byte(7), 255);
  EXPECT_EQ(srgb_byte(0.2158605F), 128);
}

TEST(Png, ComesBackAsItWasWritten) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("picture.png");
  write_png(path, {3, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {1, 1, 1}, {1, 1, 0}}});
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&png, path.c_str()), 0);
  png.format = PNG_FORMAT_RGB;
  EXPECT_EQ(png.width, 3U);
  EXPECT_EQ(png.height, 2U);
  std::vector<unsigned char> bytes(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr), 0);
  EXPECT_EQ(bytes, (std::vector<unsigned char>{255, 0, 0, 0, 255, 0, 0, 0, 255,  //
                                               0, 0, 0, 255, 255, 255, 255, 255, 0}));
}

TEST(Png, IsReadAsItWasWritten) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("picture.png");
  const Image image{2, 2, {{1, 0, 0}, {0, 1, 0}, {0.2158605F, 0, 1}, {1, 1, 1}}};
  write_png(path, image);
  const Image read = read_image(path);
  EXPECT_EQ(read.width, 2);
  EXPECT_EQ(read.height, 2);
  ASSERT_EQ(read.pixels.size(), 4U);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(read.pixels[i].isApprox(image.pixels[i], 1e-5F));
}

TEST(Png, WhatCannotBeReadIsNamed) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(read_image(folder.path("absent.png")), BadFile);
  folder.write("text.png", "no picture");
  EXPECT_THROW(read_image(folder.path("text.png")), BadFile);
}

TEST(Png, AFolderThatIsNotThereIsNamed) {
  EXPECT_THROW(write_png("/no/such/folder/a.png", {1, 1, {{1, 1, 1}}}), BadFile);
}

}  // namespace
}  // namespace isomatch::picture
