// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/npz.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "isomatch/error.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

using test::bytes;
using testing::HasSubstr;

/// An .npy file as numpy writes it.
std::string npy(std::string header, const std::string& data) {
  header += std::string(63 - (header.size() + 10) % 64, ' ') + "\n";
  return std::string("\x93NUMPY\x01\0", 8) +
         bytes<std::uint16_t>(std::endian::little, {static_cast<std::uint16_t>(header.size())}) +
         header + data;
}

class Npy : public testing::Test {
 protected:
  std::optional<NpyArray> parse(const std::string& content) const {
    return parse_npy(file_, "a", content);
  }

  std::string error(const std::string& content) const {
    try {
      parse(content);
    } catch (const BadFile& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
  InputFile file_{folder_.write("a.npz", "not looked at")};
};

TEST_F(Npy, IntegersAndFloatsOfBothByteOrders) {
  const auto big = parse(npy("{'descr': '>i2', 'fortran_order': False, 'shape': (3,), }",
                             bytes<std::int16_t>(std::endian::big, {-1, 300, 7})));
  EXPECT_EQ(big->values, (std::vector<double>{-1, 300, 7}));
  EXPECT_TRUE(big->has_integers);
  const auto single = parse(npy("{'descr': '<f4', 'fortran_order': False, 'shape': (), }",
                                bytes<float>(std::endian::little, {0.5F})));
  EXPECT_EQ(single->values, std::vector<double>{0.5});
  EXPECT_TRUE(single->shape.empty());
  EXPECT_FALSE(single->has_integers);
}

TEST_F(Npy, ColumnsFirst) {
  const auto array = parse(npy("{'descr': '|u1', 'fortran_order': True, 'shape': (2, 3), }",
                               std::string("\1\2\3\4\5\6")));
  EXPECT_EQ(array->shape, (std::vector<std::int64_t>{2, 3}));
  EXPECT_EQ(array->values, (std::vector<double>{1, 3, 5, 2, 4, 6}));
}

TEST_F(Npy, WhatHoldsNoNumbersIsLeftOut) {
  EXPECT_FALSE(parse(npy("{'descr': '|O', 'fortran_order': False, 'shape': (1,), }", "x")));
  EXPECT_FALSE(
      parse(npy("{'descr': [('a', '<i4')], 'fortran_order': False, 'shape': (1,), }", "xxxx")));
}

TEST_F(Npy, MalformedHeadersAreRefused) {
  const std::string good = "{'descr': '<i4', 'fortran_order': False, 'shape': (1,), }";
  EXPECT_THAT(error(""), HasSubstr("numpy"));
  EXPECT_THAT(error("\x93NUMPY"), HasSubstr("numpy"));
  EXPECT_THAT(error(npy(good, "xxx")), HasSubstr("does not fit its 3 bytes"));
  EXPECT_THAT(error(npy(good, "xxxxx")), HasSubstr("does not fit"));
  EXPECT_THAT(error(npy(good, "xxxx").substr(0, 40)), HasSubstr("malformed header"));
  EXPECT_THAT(error(npy("{'descr': '<i4', 'fortran_order': False}", "xxxx")),
              HasSubstr("no 'shape'"));
  for (const char* shape : {"(-1,)", "(x)", "3", "(99999999999999999999,)"})
    EXPECT_THAT(
        error(npy("{'descr': '<i4', 'fortran_order': False, 'shape': " + std::string(shape) + "}",
                  "xxxx")),
        HasSubstr("malformed shape"));
  EXPECT_THAT(
      error(npy("{'descr': '<f8', 'fortran_order': True, 'shape': (4000000000, 4000000000)}", "")),
      HasSubstr("does not fit its 0 bytes"));
}

TEST_F(Npy, RoundTrip) {
  NpyArray array{{2, 2}, {0.1, -1e300, 5e-324, 3}, false};
  EXPECT_EQ(parse(npy_bytes(array))->values, array.values);
  array = {{4}, {-1, 0, 2147483647, 9007199254740992.0}, true};
  EXPECT_EQ(parse(npy_bytes(array))->values, array.values);
  EXPECT_EQ(npy_bytes(array).size(), 128U + 32U);
}

TEST_F(Npy, OtherFilesAreNoArchives) { EXPECT_THROW(read_npz(file_), BadFile); }

}  // namespace
}  // namespace isomatch
