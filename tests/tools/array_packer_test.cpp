// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/array_packer.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tools/packed_arrays.h"

namespace isomatch::results {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Zigzag, InterleavesSigns) {
  EXPECT_EQ(zigzag(0), 0U);
  EXPECT_EQ(zigzag(-1), 1U);
  EXPECT_EQ(zigzag(1), 2U);
  EXPECT_EQ(zigzag(-2), 3U);
  EXPECT_EQ(zigzag(INT32_MIN), UINT32_MAX);
}

TEST(ArrayPacker, StoresBytesByPlane) {
  ArrayPacker packer;
  packer.add("a", std::vector<std::uint32_t>{0x0102, 0x0304}, 2);
  packer.add("b", std::vector<std::uint32_t>{7}, 1);
  EXPECT_EQ(inflated(packer.pack()), std::string("\x02\x04\x01\x03\x07"));
  EXPECT_EQ(packer.directory().size(), 2U);
  EXPECT_EQ(packer.directory()[0]["name"], "a");
  EXPECT_EQ(packer.directory()[0]["count"], 2);
  EXPECT_EQ(packer.directory()[0]["planes"], 2);
  EXPECT_EQ(packer.directory()[1]["delta"], false);
}

TEST(ArrayPacker, DifferencesHaveRoomForTheSign) {
  ArrayPacker packer;
  packer.add("a", std::vector<std::uint32_t>{65535, 0}, 2, ArrayPacker::Layout::kDelta);
  // 2 * 65535 = 0x1fffe, then -65535, which is one less.
  EXPECT_EQ(inflated(packer.pack()), std::string("\xfe\xfd\xff\xff\x01\x01"));
  EXPECT_EQ(packer.directory()[0]["planes"], 3);
}

TEST(ArrayPacker, SlowlyVaryingNumbersTakeLittleRoom) {
  std::vector<std::uint32_t> numbers(100000);
  std::iota(numbers.begin(), numbers.end(), 5);
  ArrayPacker packer;
  packer.add("a", numbers, 4, ArrayPacker::Layout::kDelta);
  EXPECT_LT(packer.pack().size(), 2000U);
}

}  // namespace
}  // namespace isomatch::results
