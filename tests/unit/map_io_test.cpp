// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/map_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "isomatch/error.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

class MapIo : public testing::Test {
 protected:
  /// The correspondence in a file of `content`, between shapes of 4 and 10 vertices.
  Correspondence read(std::string_view content, Numbering numbering = Numbering::kFromZero) const {
    return read_correspondence(folder_.write("map.txt", content), {4, 10}, numbering);
  }

  /// The message with which reading `content` fails, without the path.
  std::string failure(std::string_view content, Numbering numbering = Numbering::kFromZero) const {
    try {
      read(content, numbering);
    } catch (const BadFile& error) {
      const std::string message = error.what();
      EXPECT_THAT(message, testing::StartsWith(folder_.path("map.txt") + ": "));
      return message.substr(folder_.path("map.txt").size() + 2);
    }
    return "no failure";
  }

  TemporaryFolder folder_;
};

TEST_F(MapIo, ReadsMapOfOneVertexALine) {
  EXPECT_THAT(read("3\n-1\n0\n9\n"), ElementsAre(Match{0, 3}, Match{2, 0}, Match{3, 9}));
}

TEST_F(MapIo, ReadsMapNumberedFromOne) {
  EXPECT_THAT(read("3\n0\n1\n10", Numbering::kFromOne),
              ElementsAre(Match{0, 2}, Match{2, 0}, Match{3, 9}));
}

TEST_F(MapIo, ReadsPairsInAnyOrderWithTrailingWords) {
  EXPECT_THAT(read("2 5 0.25\r\n0 9 worst\r\n\r\n2 5 again\r\n2 1\r\n"),
              ElementsAre(Match{0, 9}, Match{2, 1}, Match{2, 5}));
}

TEST_F(MapIo, ReadsPairsNumberedFromOne) {
  EXPECT_THAT(read("1 10\n4 1\n", Numbering::kFromOne), ElementsAre(Match{0, 9}, Match{3, 0}));
}

TEST_F(MapIo, LengthOfMapMustBeNumberOfSourceVertices) {
  EXPECT_EQ(failure("1\n2\n3\n"), "the map has 3 lines, but the source has 4 vertices");
  EXPECT_EQ(failure("1\n2\n3\n4\n5\n"), "the map has 5 lines, but the source has 4 vertices");
}

TEST_F(MapIo, VertexOutOfRangeNamesLine) {
  EXPECT_EQ(failure("1\n2\n10\n4\n"),
            "line 3: vertex 10 is out of range: the target has 10 vertices, numbered from 0");
  EXPECT_THAT(failure("1\n-2\n1\n4\n"), HasSubstr("line 2: vertex -2 is out of range"));
  EXPECT_THAT(failure("1\n-1\n1\n4\n", Numbering::kFromOne), HasSubstr("line 2: vertex -1"));
  EXPECT_THAT(failure("0 1\n4 1\n"), HasSubstr("line 2: vertex 4 is out of range: the source"));
  EXPECT_THAT(failure("0 1\n1 -1\n"), HasSubstr("line 2: vertex -1 is out of range: the target"));
  EXPECT_THAT(failure("0 1\n", Numbering::kFromOne), HasSubstr("line 1: vertex 0"));
  EXPECT_THAT(failure("1\n2\n3\n99999999999\n"), HasSubstr("line 4: vertex 99999999999"));
}

TEST_F(MapIo, WhatIsNoIntegerNamesLine) {
  EXPECT_THAT(failure("1\n2\nthree\n4\n"), HasSubstr("line 3: expected an integer"));
  EXPECT_THAT(failure("1\n2.5\n3\n4\n"), HasSubstr("line 2: expected an integer"));
  EXPECT_THAT(failure("1\n2\n3 4\n4\n"), HasSubstr("line 3: expected the end of the line"));
  EXPECT_THAT(failure("1 2\n2\n"), HasSubstr("line 2: expected an integer, but the line ends"));
  EXPECT_THAT(failure("1\n2\n3\n99999999999999999999\n"), HasSubstr("line 4"));
}

TEST_F(MapIo, EmptyAndMissingFilesFail) {
  EXPECT_NE(failure(""), "no failure");
  EXPECT_EQ(failure("\n \n"), "no vertices in it");
  EXPECT_THROW(read_correspondence(folder_.path("absent.txt"), {4, 10}), BadFile);
}

TEST_F(MapIo, VtsIsNumberedFromOne) {
  EXPECT_THAT(read_vts(folder_.write("a.vts", "1\n10\n3\n3"), 10), ElementsAre(0, 9, 2, 2));
  EXPECT_THROW(read_vts(folder_.write("a.vts", "0\n"), 10), BadFile);
  EXPECT_THROW(read_vts(folder_.write("a.vts", "1\n11\n"), 10), BadFile);
  EXPECT_THROW(read_vts(folder_.write("a.vts", "1 2\n"), 10), BadFile);
  EXPECT_THROW(read_vts(folder_.write("a.vts", "\n"), 10), BadFile);
}

TEST_F(MapIo, MapSurvivesRoundTrip) {
  const VertexMap map{3, kUnmatched, 0, 9};
  write_source_to_target(folder_.path("map.txt"), map);
  EXPECT_EQ(test::read_file(folder_.path("map.txt")), "3\n-1\n0\n9\n");
  EXPECT_EQ(read_source_to_target(folder_.path("map.txt"), {4, 10}), map);
}

TEST_F(MapIo, CorrespondenceSurvivesRoundTrip) {
  const Correspondence matches{{0, 9}, {2, 1}, {2, 5}};
  const std::vector<double> d_iso{0.1, 0, 1.0 / 3};
  write_correspondence(folder_.path("pairs.txt"), matches, d_iso);
  EXPECT_EQ(test::read_file(folder_.path("pairs.txt")), "0 9 0.1\n2 1 0\n2 5 0.3333333333333333\n");
  EXPECT_EQ(read_correspondence(folder_.path("pairs.txt"), {4, 10}), matches);
}

TEST_F(MapIo, VtsSurvivesRoundTrip) {
  write_vts(folder_.path("a.vts"), {4, 0, 9});
  EXPECT_THAT(read_vts(folder_.path("a.vts"), 10), ElementsAre(4, 0, 9));
}

TEST_F(MapIo, FailedWriteLeavesNothing) {
  const std::vector<double> too_short{0.5};
  EXPECT_THROW(write_correspondence(folder_.path("pairs.txt"), {{0, 1}, {1, 2}}, too_short),
               InvalidInput);
  EXPECT_THROW(write_vts(folder_.path("absent/a.vts"), {1}), BadFile);
  EXPECT_THAT(folder_.names(), ElementsAre());
}

}  // namespace
}  // namespace isomatch
