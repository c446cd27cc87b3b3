// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <string>

#include "support/mesh_files.h"

namespace isomatch {
namespace {

using test::read_content;
using test::read_error;
using test::tetrahedron;

constexpr std::string_view kBody =
    "0 0 0\n1.5 0 0\n0 2 0\n0 0 -0.25\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

void expect_tetrahedron(const std::string& content) {
  SCOPED_TRACE(content);
  const Mesh mesh = read_content("off", content);
  EXPECT_EQ(mesh.vertices, tetrahedron().vertices);
  EXPECT_EQ(mesh.faces, tetrahedron().faces);
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

TEST(ReadOff, TakesCountsOnTheirOwnLineOrBehindTheKeyword) {
  const std::string body(kBody);
  expect_tetrahedron("OFF\n4 4 6\n" + body);
  expect_tetrahedron("OFF 4 4 6\n" + body);
  expect_tetrahedron("OFF4 4 6\n" + body);
  expect_tetrahedron("OFF\n4 4\n" + body);
}

TEST(ReadOff, DoesWithoutKeywordIfCountsComeFirst) {
  expect_tetrahedron("4 4 6\n" + std::string(kBody));
}

TEST(ReadOff, PassesOverCommentsBlankLinesAndByteOrderMark) {
  expect_tetrahedron("\xef\xbb\xbfOFF\n" + ("4 4 6\n" + std::string(kBody)));
  expect_tetrahedron(
      "# a comment\n\n  \t\nOFF # another\n\n#and\n 4  4\t6 #more\n\n0 0 0# here\n#\n" +
      replaced(std::string(kBody).substr(6), "\n", "\n# between\n\n"));
}

TEST(ReadOff, TakesAllLineEnds) {
  const std::string content = "OFF\n4 4 6\n" + std::string(kBody);
  expect_tetrahedron(replaced(content, "\n", "\r\n"));
  expect_tetrahedron(replaced(content, "\n", "\r"));
  expect_tetrahedron(content.substr(0, content.size() - 1));
}

TEST(ReadOff, PassesOverColoursNormalsAndTextureCoordinates) {
  const std::string faces = "3 0 2 1 255 0 0\n3 0 1 3 0.5 0.5 0.5 1.0\n3 1 2 3 7\n3 2 0 3 # none\n";
  for (const char* keyword :
       {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"}) {
    expect_tetrahedron(keyword + ("\n4 4 6\n0 0 0 1 2 3 4\n1.5 0 0 nan 0 0 0 0 0 0 0 0\n"
                                  "0 2 0 0.1\n0 0 -0.25 255 255 255 255\n" +
                                  faces));
  }
}

TEST(ReadOff, TakesNumbersInAnyNotation) {
  const Mesh mesh =
      read_content("off", "OFF\n3 1 0\n+1.5 -0 1e-3\n1E+2 .5 5.\n00 -0.0 4.9e-324\n3 0 1 2\n");
  EXPECT_EQ(mesh.vertices[0], Point(1.5, 0, 1e-3));
  EXPECT_TRUE(std::signbit(mesh.vertices[0].y()));
  EXPECT_EQ(mesh.vertices[1], Point(100, 0.5, 5));
  EXPECT_EQ(mesh.vertices[2], Point(0, 0, 4.9e-324));
}

TEST(ReadOff, NumbersTooSmallForADoubleAreZero) {
  const Mesh mesh =
      read_content("off", "OFF\n3 1 0\n1e-400 -2.5E-99999 3e-324\n0 1 0\n1 0 0\n3 0 1 2\n");
  EXPECT_EQ(mesh.vertices[0], Point(0, 0, 4.9e-324));
}

TEST(ReadOff, CutsPolygonsIntoFans) {
  MeshReadReport report;
  const Mesh mesh = read_content(
      "off", "OFF\n5 3 0\n0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 1 2 3 4 0\n3 0 1 2\n4 4 3 2 1\n",
      &report);
  EXPECT_EQ(mesh.faces,
            (std::vector<Face>{{1, 2, 3}, {1, 3, 4}, {1, 4, 0}, {0, 1, 2}, {4, 3, 2}, {4, 2, 1}}));
  EXPECT_EQ(report.triangulated_polygons, 2);
  EXPECT_EQ(report.merged_vertices, 0);
}

TEST(ReadOff, KeepsDefectsOfTheMesh) {
  const Mesh mesh = read_content(
      "off", "OFF\n5 4 0\n1 1 1\n0 0 0\n0 0 0\n2 0 0\n9 9 9\n3 0 1 2\n3 0 1 2\n3 3 3 3\n3 2 1 0\n");
  EXPECT_EQ(mesh.num_vertices(), 5);
  EXPECT_EQ(mesh.vertices[4], Point(9, 9, 9));
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {0, 1, 2}, {3, 3, 3}, {2, 1, 0}}));
}

TEST(ReadOff, NamesBadHeaders) {
  EXPECT_EQ(read_error("off", "# only\n\n"), "the file holds nothing but blanks and comments");
  EXPECT_EQ(read_error("off", "\n\nhello\n"),
            "line 3: expected OFF or the number of vertices, found 'hello'");
  EXPECT_EQ(read_error("off", "4OFF\n4 4 6\n"), "line 1: unsupported kind of OFF file: '4OFF'");
  EXPECT_EQ(read_error("off", "OFF BINARY\n\x01\x02"),
            "line 1: binary OFF files are not supported");
  EXPECT_EQ(read_error("off", "OFF"), "line 1: the file ends before the number of vertices");
  EXPECT_EQ(read_error("off", "OFF\n4\n"), "line 2: expected an integer, but the line ends");
  EXPECT_EQ(read_error("off", "OFF\n4 x 6\n"), "line 2: expected an integer, found 'x'");
  EXPECT_EQ(read_error("off", "OFF\n4.5 4 6\n"), "line 2: expected an integer, found '4.5'");
  EXPECT_EQ(read_error("off", "0 0 0.5\n"), "line 1: expected an integer, found '0.5'");
  EXPECT_EQ(read_error("off", "OFF 4 4 6 1\n"), "line 1: expected the end of the line, found '1'");
}

TEST(ReadOff, NamesCountsThatCannotBe) {
  const std::string body(kBody);
  EXPECT_EQ(read_error("off", "OFF\n-4 4 6\n" + body),
            "line 2: the number of vertices is negative (-4)");
  EXPECT_EQ(read_error("off", "OFF\n4 -1 6\n" + body),
            "line 2: the number of faces is negative (-1)");
  EXPECT_EQ(read_error("off", "OFF\n2000000000 4 6\n" + body),
            "line 2: 2000000000 vertices announced, more than the 64 bytes that follow can hold");
  EXPECT_EQ(read_error("off", "OFF\n4 4000000000000 6\n" + body),
            "line 2: 4000000000000 faces announced, more than the 64 bytes that follow can hold");
  EXPECT_EQ(read_error("off", "OFF\n99999999999999999999 4 6\n" + body),
            "line 2: expected an integer of at most 64 bits, found '99999999999999999999'");
  EXPECT_EQ(read_error("off", "OFF\n0 0 0\n"), "the mesh has no vertices");
  EXPECT_EQ(read_error("off", "OFF\n1 0 0\n0 0 0\n"), "the mesh has no faces");
}

TEST(ReadOff, NamesBadVertices) {
  const auto error = [](const std::string& line) {
    return read_error("off", "OFF\n3 1 0\n0 0 0\n" + line + "\n0 2 0\n3 0 1 2\n");
  };
  EXPECT_EQ(error("1 2"), "line 4: expected a number, but the line ends");
  EXPECT_EQ(error("1 2 # 3"), "line 4: expected a number, but the line ends");
  EXPECT_EQ(error("1 2 three"), "line 4: expected a number, found 'three'");
  EXPECT_EQ(error("1,0 2 3"), "line 4: expected a number, found '1,0'");
  EXPECT_EQ(error("1 +-2 3"), "line 4: expected a number, found '+-2'");
  EXPECT_EQ(error("1 0x1p3 3"), "line 4: expected a number, found '0x1p3'");
  EXPECT_EQ(error("0 0 1e999"), "line 4: expected a number that fits a double, found '1e999'");
  EXPECT_EQ(error("1" + std::string(400, '0') + " 0 0"),
            "line 4: expected a number that fits a double, found '100000000000000000000000...'");
  EXPECT_EQ(error("1" + std::string(400, '0') + "e-10 0 0"),
            "line 4: expected a number that fits a double, found '100000000000000000000000...'");
  EXPECT_EQ(error("\x01\xff\n 0 0"), "line 4: expected a number, found '\\x01\\xff'");
}

TEST(ReadOff, NamesBadFaces) {
  const auto error = [](const std::string& line) {
    return read_error("off",
                      "OFF\r\n3 2 0\r\n0 0 0\r\n1 0 0\r\n0 2 0\r\n3 0 1 2\r\n" + line + "\r\n");
  };
  EXPECT_EQ(error("3 0 1 3"),
            "line 7: vertex index 3 is out of range, there are 3 vertices counted from 0");
  EXPECT_EQ(error("3 0 -1 2"),
            "line 7: vertex index -1 is out of range, there are 3 vertices counted from 0");
  EXPECT_EQ(error("3 0 1 4294967296"),
            "line 7: vertex index 4294967296 is out of range, there are 3 vertices counted from 0");
  EXPECT_EQ(error("-3 0 1 2"), "line 7: a face cannot have -3 corners");
  EXPECT_EQ(error("4 0 1 2"), "line 7: expected an integer, but the line ends");
  EXPECT_EQ(error("9000000000000000000 0 1 2"), "line 7: expected an integer, but the line ends");
  EXPECT_EQ(error("3 0 1 2.0"), "line 7: expected an integer, found '2.0'");
}

TEST(ReadOff, NamesWhereTheFileIsTooShortOrTooLong) {
  const std::string start = "OFF\n3 1 0\n0 0 0\n1 0 0\n";
  EXPECT_EQ(read_error("off", start + "# comments fill the file"),
            "line 5: the file ends after 2 of 3 vertices");
  EXPECT_EQ(read_error("off", start + "0 1 0\n"), "line 6: the file ends after 0 of 1 faces");
  EXPECT_EQ(read_error("off", start + "0 1 0\n3 0 1 2\n\n3 0 2 1\n"),
            "line 8: more lines follow than the 3 vertices and 1 faces announced");
}

}  // namespace
}  // namespace isomatch
