// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/map_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "isomatch/error.h"
#include "support/random.h"
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
    return message([&] { read(content, numbering); });
  }

  /// The message with which `reading` map.txt fails, without the path.
  template <class Reading>
  std::string message(const Reading& reading) const {
    try {
      reading();
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

TEST_F(MapIo, LandmarksKeepTheirOrder) {
  EXPECT_THAT(read_landmarks(folder_.write("pairs.txt", "2 5 # nose\n\n0 9\n"), {4, 10}),
              ElementsAre(Match{2, 5}, Match{0, 9}));
}

TEST_F(MapIo, LandmarksOfNumpyAreRead) {
  EXPECT_THAT(read_landmarks(folder_.write("pairs.txt", "# s t\n2.0e+00 5.00e+00\n"), {4, 10}),
              ElementsAre(Match{2, 5}));
  EXPECT_THAT(read_vertex_list(folder_.write("list.txt", "# v\n2.0e+00\n0\n"), 3),
              ElementsAre(2, 0));
}

TEST_F(MapIo, LandmarksOfSpreadsheetsAreRead) {
  for (const char* content :
       {"2,5\n0,9\n", "\"source\",\"target\"\r\n2,5\r\n0,9\r\n", "2;5\n0;9", "s;t\n2; 5\n0 ;9\n",
        "2\t5\n0\t9\n", "# by hand\nsource target\n\n2 5 # nose\n0 9\n"})
    EXPECT_THAT(read_landmarks(folder_.write("pairs.csv", content), {4, 10}),
                ElementsAre(Match{2, 5}, Match{0, 9}))
        << content;
}

TEST_F(MapIo, LandmarksFromOneAreShifted) {
  EXPECT_THAT(
      read_landmarks(folder_.write("pairs.txt", "4 10\n1 1\n"), {4, 10}, Numbering::kFromOne),
      ElementsAre(Match{3, 9}, Match{0, 0}));
}

TEST_F(MapIo, VertexListsNamedVtsAreNumberedFromOne) {
  EXPECT_THAT(read_vertex_list(folder_.write("list.vts", "3\n1\n"), 3), ElementsAre(2, 0));
}

TEST_F(MapIo, BadLandmarksNameLine) {
  const auto failure = [&](std::string_view content) {
    return message([&] { read_landmarks(folder_.write("map.txt", content), {4, 10}); });
  };
  EXPECT_EQ(failure("2 5\n0 9\n2 5\n"), "line 3: source vertex 2 has a landmark already");
  EXPECT_THAT(failure("2 5\n4 9\n"), HasSubstr("line 2: vertex 4 is out of range: the source"));
  EXPECT_THAT(failure("2 5\n3 -1\n"), HasSubstr("line 2: vertex -1 is out of range: the target"));
  EXPECT_THAT(failure("3\n1\n2\n0\n"), HasSubstr("line 1: expected an integer"));
  EXPECT_EQ(failure("\n"), "no landmarks in it");
  EXPECT_EQ(failure("nose tail\n"), "no landmarks in it");
  EXPECT_THAT(failure("2 5\n0 9 1\n"),
              HasSubstr("line 2: more than a source and a target vertex, '1'"));
  EXPECT_THAT(failure("2 5 0 9 1 3\n"), HasSubstr("each landmark has a line of its own"));
  EXPECT_THAT(failure("2,5,nose\n"), HasSubstr("line 1: more than a source and a target"));
  EXPECT_THAT(failure("2,,5\n"), HasSubstr("line 1: expected an integer, but the column is empty"));
  EXPECT_THAT(failure("2,5\n0;9\n"), HasSubstr("separated by ',' before, and by ';' here"));
  EXPECT_THAT(failure("s t\nO 9\n"), HasSubstr("line 2: expected an integer, found 'O'"));
}

TEST_F(MapIo, ReadsPointsOnTriangles) {
  const auto read = [&](std::string_view content, Numbering numbering) {
    return read_surface_map(folder_.write("map.bary.txt", content), {3, 7}, numbering);
  };
  const SurfaceMap expected{{6, {0.25, 0.75, 0}}, {}, {0, {1, 0, 0}}};
  EXPECT_EQ(read("6 .25 0.75 0\r\n\r\n-1 0 0 0\r\n0 1 0 0", Numbering::kFromZero), expected);
  EXPECT_EQ(read("7 .25 .75 0\n0 0 0 0\n1 1 0 0\n", Numbering::kFromOne), expected);
}

TEST_F(MapIo, BadPointsNameLine) {
  const auto failure = [&](std::string_view content) {
    return message([&] { read_surface_map(folder_.write("map.txt", content), {2, 7}); });
  };
  EXPECT_EQ(failure("0 1 0 0\n7 1 0 0\n"),
            "line 2: face 7 is out of range: the target has 7 faces, numbered from 0");
  EXPECT_THAT(failure("0 1 0 0\n-2 0 0 0\n"), HasSubstr("line 2: face -2 is out of range"));
  EXPECT_EQ(failure("0 1 0 0\n1 .5 .6 -.1\n"), "line 2: weight -0.1 is not in [0, 1]");
  EXPECT_THAT(failure("0 1 0 0\n1 .5 .25 .125\n"), HasSubstr("line 2: the weights sum to 0.875"));
  EXPECT_THAT(failure("0 1 0 0\n-1 1 0 0\n"), HasSubstr("line 2: the weights sum to 1"));
  EXPECT_THAT(failure("0 1 0\n"), HasSubstr("line 1: expected a number, but the line ends"));
  EXPECT_THAT(failure("0 1 0 0 0\n"), HasSubstr("line 1: expected the end of the line"));
  EXPECT_THAT(failure("0 1 nan 0\n"), HasSubstr("line 1: expected a finite number"));
  EXPECT_THAT(failure("a 1 0 0\n"), HasSubstr("line 1: expected an integer"));
  EXPECT_EQ(failure("0 1 0 0\n"), "the map has 1 lines, but the source has 2 vertices");
  EXPECT_NE(failure(""), "no failure");
}

TEST_F(MapIo, WeightsMayBeOffByRounding) {
  const std::string path =
      folder_.write("map.txt", "0 1.0000005 -0.0000005 0\n0 .3333333 .3333333 .3333333\n");
  const SurfaceMap map = read_surface_map(path, {2, 1});
  EXPECT_EQ(map[0].weights[1], -0.0000005);
  EXPECT_EQ(map[1].weights[2], 0.3333333);
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

TEST_F(MapIo, PointsSurviveRoundTrip) {
  test::Random random(1);
  SurfaceMap map{{}, {3, {0.1, 0.2, 0.7}}};
  for (int i = 0; i < 100; ++i) {
    const double a = random.uniform(), b = (1 - a) * random.uniform();
    map.push_back({random.index(7), {a, b, 1 - a - b}});
  }
  const std::string path = folder_.path("map.bary.txt");
  write_surface_map(path, map);
  EXPECT_THAT(test::read_file(path), testing::StartsWith("-1 0 0 0\n3 0.1 0.2 0.7\n"));
  EXPECT_EQ(read_surface_map(path, {102, 7}), map);
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
