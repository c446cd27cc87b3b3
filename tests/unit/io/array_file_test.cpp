// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/array_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>

#include <limits>
#include <string>

#include "io/npz.h"
#include "isomatch/error.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class ArrayFile : public testing::Test {
 protected:
  void write(const NumpyArray& array) const { write_arrays(path_, {{"a", array}}); }

  NpyArray read() const { return read_npz(InputFile(path_)).at("a"); }

  /// The bytes of the array in the archive.
  std::string content() const {
    zip_t* const archive = zip_open(path_.c_str(), ZIP_RDONLY, nullptr);
    zip_file_t* const entry = zip_fopen(archive, "a.npy", 0);
    std::string bytes(1000, '\0');
    bytes.resize(zip_fread(entry, bytes.data(), bytes.size()));
    zip_fclose(entry);
    zip_discard(archive);
    return bytes;
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.path("a.npz");
};

TEST_F(ArrayFile, HasNumbers) {
  write({{2, 2}, std::vector<double>{0.1, -1e300, 5e-324, 3}});
  EXPECT_EQ(read().shape, (std::vector<std::int64_t>{2, 2}));
  EXPECT_THAT(read().values, ElementsAre(0.1, -1e300, 5e-324, 3));
  EXPECT_FALSE(read().has_integers);
  write({{1}, std::vector{std::numeric_limits<double>::quiet_NaN()}});
  EXPECT_THAT(read().values, ElementsAre(testing::IsNan()));
  write({{3}, std::vector<std::int32_t>{-1, 0, 2147483647}});
  EXPECT_THAT(read().values, ElementsAre(-1, 0, 2147483647));
  EXPECT_TRUE(read().has_integers);
  EXPECT_THAT(content(), HasSubstr("'<i4'"));
  write({{0, 3}, std::vector<double>{}});
  EXPECT_THAT(content(), HasSubstr("(0, 3,)"));
}

TEST_F(ArrayFile, HasTruthValues) {
  write({{3}, std::vector<bool>{true, false, true}});
  EXPECT_THAT(content(), HasSubstr("'|b1'"));
  EXPECT_THAT(content(), EndsWith(std::string("\n\1\0\1", 4)));
}

TEST_F(ArrayFile, HasTexts) {
  write({{2}, std::vector<std::string>{"\xC3\xA4, ", "\xF0\x9F\x90\x88"}});
  EXPECT_THAT(content(), HasSubstr("'<U3'"));
  EXPECT_THAT(content(), EndsWith(std::string(
                             "\n\xE4\0\0\0,\0\0\0 \0\0\0\x08\xF4\x01\0\0\0\0\0\0\0\0\0", 25)));
  write({{1}, std::vector<std::string>{""}});
  EXPECT_THAT(content(), HasSubstr("'<U1'"));
}

TEST_F(ArrayFile, WhatIsNotUtf8IsReplaced) {
  const std::string replaced("\xFD\xFF\0\0", 4);
  for (const char* text : {"\xFC", "\xC3", "\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80"}) {
    write({{1}, std::vector<std::string>{text}});
    EXPECT_THAT(content(), HasSubstr("\n" + replaced)) << text;
  }
}

TEST_F(ArrayFile, ValuesMustFitTheShape) {
  EXPECT_THROW(write({{2}, std::vector<double>{1}}), InvalidInput);
  EXPECT_TRUE(folder_.names().empty());
}

}  // namespace
}  // namespace isomatch
