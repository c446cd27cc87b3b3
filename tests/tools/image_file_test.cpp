// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <array>
#include <memory>
#include <random>

#include "isomatch/error.h"
#include "results/picture/image.h"
#include "support/temporary_folder.h"

namespace isomatch::picture {
namespace {

using testing::HasSubstr;

constexpr int kSide = 32;
constexpr std::array<unsigned char, 3> kColor = {200, 100, 50};

struct JpegKind {
  TJSAMP sampling = TJSAMP_444;
  int flags = 0;
  bool is_cmyk = false;
};

/// A JPEG file of one colour.
std::string jpeg(const JpegKind& kind = {}) {
  std::string pixels;
  for (int i = 0; i < kSide * kSide; ++i) {
    for (const unsigned char channel : kColor) pixels += static_cast<char>(channel);
    // No black ink, as Adobe's programs write it.
    if (kind.is_cmyk) pixels += '\xff';
  }
  const std::unique_ptr<void, int (*)(tjhandle)> handle(tjInitCompress(), tjDestroy);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(handle.get(), reinterpret_cast<unsigned char*>(pixels.data()), kSide, 0,
                        kSide, kind.is_cmyk ? TJPF_CMYK : TJPF_RGB, &bytes, &size, kind.sampling,
                        95, kind.flags),
            0)
      << tjGetErrorStr2(handle.get());
  std::string file(reinterpret_cast<char*>(bytes), size);
  tjFree(bytes);
  return file;
}

class ImageFile : public testing::Test {
 protected:
  Image read(const std::string& content, std::string_view name = "image") const {
    return read_image(folder_.write(name, content));
  }

  std::string error(const std::string& content) const {
    try {
      read(content);
    } catch (const BadFile& error) {
      return error.what();
    }
    return "nothing was thrown";
  }

  std::string png() const {
    write_png(folder_.path("a.png"), {kSide, kSide, std::vector<Color>(kSide * kSide, {0, 1, 0})});
    return test::read_file(folder_.path("a.png"));
  }

  /// Fails or not, but comes back.
  void try_to_read(const std::string& content) const {
    try {
      read(content);
    } catch (const BadFile&) {
    }
  }

  const test::TemporaryFolder folder_;
};

void expect_color(const Image& image, std::array<int, 3> color, std::string_view what) {
  EXPECT_EQ(image.width, kSide) << what;
  EXPECT_EQ(image.height, kSide) << what;
  ASSERT_EQ(image.pixels.size(), static_cast<std::size_t>(kSide * kSide)) << what;
  // JPEG rounds colours on several ways.
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(srgb_byte(image.at(kSide / 2, kSide / 3)[k]), color[k], 3) << what;
}

TEST_F(ImageFile, JpegsOfEveryKindAreRead) {
  constexpr std::array<int, 3> kRgb = {kColor[0], kColor[1], kColor[2]};
  expect_color(read(jpeg()), kRgb, "baseline");
  expect_color(read(jpeg({.sampling = TJSAMP_420})), kRgb, "4:2:0");
  expect_color(read(jpeg({.sampling = TJSAMP_411})), kRgb, "4:1:1");
  expect_color(read(jpeg({.flags = TJFLAG_PROGRESSIVE})), kRgb, "progressive");
  expect_color(read(jpeg({.is_cmyk = true})), kRgb, "CMYK");
  // The luma of the colour, by ITU-R BT.601.
  expect_color(read(jpeg({.sampling = TJSAMP_GRAY})), {124, 124, 124}, "greyscale");
}

TEST_F(ImageFile, TheContentTellsTheKind) {
  EXPECT_EQ(read(jpeg(), "skin.png").width, kSide);
  EXPECT_EQ(read(png(), "skin.jpg").width, kSide);
  EXPECT_EQ(read(jpeg(), "skin.tga").width, kSide);
}

TEST_F(ImageFile, OtherFilesAreNamed) {
  EXPECT_THAT(error("no picture"), HasSubstr("is neither a PNG nor a JPEG image"));
  EXPECT_THAT(error(""), HasSubstr("is neither a PNG nor a JPEG image"));
  EXPECT_THROW(read_image(folder_.path("absent.png")), BadFile);
  EXPECT_THROW(read_image(folder_.path("")), BadFile);
}

TEST_F(ImageFile, TruncatedOnesAreRefused) {
  // All pixels stand before the marks of the ends.
  constexpr std::size_t kJpegEnd = 2, kPngEnd = 16;
  const auto expect_refused = [&](const std::string& whole, std::size_t end) {
    for (std::size_t size = 0; size < whole.size() - end; ++size)
      EXPECT_THROW(read(whole.substr(0, size)), BadFile) << size << " of " << whole.size();
  };
  expect_refused(jpeg(), kJpegEnd);
  expect_refused(jpeg({.flags = TJFLAG_PROGRESSIVE}), kJpegEnd);
  expect_refused(jpeg({.is_cmyk = true}), kJpegEnd);
  expect_refused(png(), kPngEnd);
}

TEST_F(ImageFile, DamagedOnesDoNotCrash) {
  std::mt19937 random(1);
  for (const std::string& whole :
       {jpeg(), jpeg({.sampling = TJSAMP_420, .flags = TJFLAG_PROGRESSIVE}),
        jpeg({.is_cmyk = true}), jpeg({.sampling = TJSAMP_GRAY}), png()}) {
    for (int attempt = 0; attempt < 300; ++attempt) {
      std::string damaged = whole;
      for (int i = 0; i < 3; ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
      try_to_read(damaged);
    }
  }
}

TEST_F(ImageFile, HugeAnnouncementsAreRefused) {
  std::string large = jpeg();
  // The frame's header: marker, length, precision, height, width.
  const std::size_t frame = large.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  large.replace(frame + 5, 4, "\xff\x00\xff\x00", 4);
  EXPECT_THAT(error(large), HasSubstr("more pixels than"));
}

}  // namespace
}  // namespace isomatch::picture
