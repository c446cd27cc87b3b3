// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/files/image_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/temporary_folder.h"

namespace isomatch::results {
namespace {

class ImageLineTest : public testing::Test {
 protected:
  ImageLineTest() {
    std::filesystem::create_directory(folder_.path("tex"));
    for (const char* name : {"skin.png", "my skin.png", "skin #1.png", "2 4.png", "tex/low.png"})
      folder_.write(name, "");
  }

  /// The name in the line, and "!" before it if it is no file; "-" if there is none.
  std::string name(const std::string& line) const {
    const auto image = image_line(line, folder_.path("body.mtl"));
    if (!image) return "-";
    EXPECT_EQ(image->before + image->name + image->after, line);
    return (image->path.empty() ? "!" : "") + image->name;
  }

  const test::TemporaryFolder folder_;
};

TEST_F(ImageLineTest, NamesMayHoldBlanksAndSigns) {
  EXPECT_EQ(name("map_Kd skin.png"), "skin.png");
  EXPECT_EQ(name("\tmap_Kd   my skin.png \r"), "my skin.png");
  EXPECT_EQ(name("map_Kd skin #1.png"), "skin #1.png");
  EXPECT_EQ(name("map_Kd tex\\low.png"), "tex\\low.png");
  EXPECT_EQ(name("map_Kd \"my skin.png\""), "\"my skin.png\"");
}

TEST_F(ImageLineTest, OptionsMayStandBeforeTheName) {
  EXPECT_EQ(name("map_Kd -s 1 1 1 -bm 0.5 -clamp on my skin.png"), "my skin.png");
  EXPECT_EQ(name("map_Kd -blendu off -blendv off -boost 1 -cc on -imfchan r my skin.png"),
            "my skin.png");
  EXPECT_EQ(name("map_Kd -mm 0 1 -texres 64 -colorspace sRGB -t 1 -o 0 0 my skin.png"),
            "my skin.png");
  EXPECT_EQ(name("refl -type cube_top my skin.png"), "my skin.png");
  EXPECT_EQ(name("map_Kd -unheard 3 of my skin.png"), "my skin.png");
}

TEST_F(ImageLineTest, NumbersAreOfTheOptionUnlessOfAFile) {
  EXPECT_EQ(name("map_Kd -s 1 2 4.png"), "2 4.png");
  EXPECT_EQ(name("map_Kd -s 1 1 1 2 4.png"), "2 4.png");
  EXPECT_EQ(name("map_Kd -s 1 2 3.png"), "!3.png");
  EXPECT_EQ(name("map_Kd -s 1 2"), "-");
}

TEST_F(ImageLineTest, CommentsAndOptionsMayFollow) {
  EXPECT_EQ(name("map_Kd my skin.png # of the body"), "my skin.png");
  EXPECT_EQ(name("map_Kd skin #1.png # of the body"), "skin #1.png");
  EXPECT_EQ(name("bump my skin.png -bm 0.5"), "my skin.png");
}

TEST_F(ImageLineTest, MissingNamesStayWhole) {
  EXPECT_EQ(name("map_Kd no skin.png"), "!no skin.png");
  EXPECT_EQ(name("map_Kd not my skin.png"), "!not my skin.png");
  EXPECT_EQ(name("map_Kd -s 1 1 1 not my skin.png"), "!not my skin.png");
  EXPECT_EQ(name("map_Kd C:\\Users\\me\\My Scans\\my skin.png"),
            "!C:\\Users\\me\\My Scans\\my skin.png");
  EXPECT_EQ(name("map_Kd -clamp on C:/My Scans/skin.png"), "!C:/My Scans/skin.png");
}

TEST_F(ImageLineTest, OtherLinesNameNone) {
  for (const char* line : {"", "Kd 1 1 1", "newmtl skin.png", "# map_Kd skin.png", "map_aat on",
                           "map_Kd", "map_Kd -s 1 1 1", "map_Kd -clamp", "map_Kd -s"})
    EXPECT_EQ(name(line), "-") << line;
}

TEST_F(ImageLineTest, LongLinesAreNoTrouble) {
  std::string line = "map_Kd -x";
  for (int i = 0; i < 100000; ++i) line += " #";
  EXPECT_EQ(name(line).size(), 200003U);
}

TEST_F(ImageLineTest, NamesOfMaterialsAreTheRestOfTheLine) {
  EXPECT_EQ(new_material("newmtl Body Upper #1 \r"), "Body Upper #1");
  EXPECT_EQ(new_material(" newmtl\tskin"), "skin");
  EXPECT_EQ(new_material("newmtl"), "");
  EXPECT_EQ(new_material("newmtlx skin"), std::nullopt);
  EXPECT_EQ(new_material("Kd 1 1 1"), std::nullopt);
}

}  // namespace
}  // namespace isomatch::results
