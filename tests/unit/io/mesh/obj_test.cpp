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

const std::string kVertices = "v 0 0 0\nv 1.5 0 0\nv 0 2 0\nv 0 0 -0.25\n";

void expect_tetrahedron(const std::string& content) {
  SCOPED_TRACE(content);
  const Mesh mesh = read_content("obj", content);
  EXPECT_EQ(mesh.vertices, tetrahedron().vertices);
  EXPECT_EQ(mesh.faces, tetrahedron().faces);
}

TEST(ReadObj, TakesCornersInEveryForm) {
  expect_tetrahedron(kVertices + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  expect_tetrahedron(kVertices +
                     "f 1/1 3/2 2/3\nf 1//1 2//2 4//3\nf 2/1/1 3/2/2 4/3/3\nf 3/ 1// 4");
  expect_tetrahedron(kVertices + "f -4/-1 -2 -3\nf -4 -3//-1 -1\nf 2 -2 -1/1/1\nf 3 1 -1\n");
}

TEST(ReadObj, NegativeIndicesCountBackFromTheFace) {
  const Mesh mesh =
      read_content("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -3 -2 -1");
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {1, 2, 3}}));
}

TEST(ReadObj, FacesMayPrecedeTheirVertices) {
  expect_tetrahedron("f 1 3 2\nf 1 2 4\n" + kVertices + "f 2 3 4\nf 3 1 4\n");
}

TEST(ReadObj, PassesOverEverythingButVerticesAndFaces) {
  expect_tetrahedron(
      "\xef\xbb\xbf# Blender\nmtllib a b.mtl\no thing\n\n" + kVertices +
      "vt 0 0\nvn nan 0 1\nvp 1\ng one two\ns off\nusemtl \xc3\xa4\nl 1 2\np 1\ncurv 0 1 1 2\n"
      "f 1 3 2 # first\nf\t1 2  4 \nfoo\n  f 2 3 4\nf 3 1 4\nend\n");
}

TEST(ReadObj, PassesOverWeightsAndColours) {
  expect_tetrahedron(
      "v 0 0 0 1.0\nv 1.5 0 0 0.1 0.2 0.3\nv 0 2 0 0.1 0.2 0.3 1.0\nv 0 0 -0.25 # none\n"
      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
}

TEST(ReadObj, JoinsLinesThatEndInABackslash) {
  expect_tetrahedron("v 0 \\\n 0 0\nv 1.5 0\\\r\n 0\nv 0 2 0\nv 0 0 -0.25\ng a \\\nf 9 9 9\n" +
                     std::string("f 1 3 \\\n\\\n2\nf 1 2 4\nf 2 3 4\\\n\nf 3 1 4\\\n"));
}

TEST(ReadObj, CommentsAreNotContinued) {
  expect_tetrahedron("# C:\\models\\\n" + kVertices + "f 1 3 2 #\\\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
}

TEST(ReadObj, TakesAllLineEnds) {
  for (const std::string end : {"\r\n", "\r"}) {
    std::string content;
    for (const char c : kVertices + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4")
      content += c == '\n' ? end : std::string(1, c);
    expect_tetrahedron(content);
  }
}

TEST(ReadObj, CutsPolygonsIntoFans) {
  MeshReadReport report;
  const Mesh mesh =
      read_content("obj", kVertices + "f 1 2 3 4\nf 1 2 3\nf 4/1 3/1 2/1 1/1 4/1\n", &report);
  EXPECT_EQ(mesh.faces,
            (std::vector<Face>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {3, 2, 1}, {3, 1, 0}, {3, 0, 3}}));
  EXPECT_EQ(report.triangulated_polygons, 2);
}

TEST(ReadObj, NamesBadVertices) {
  EXPECT_EQ(read_error("obj", "v 0 0 0\nv 1 2\n"), "line 2: expected a number, but the line ends");
  EXPECT_EQ(read_error("obj", "v 0 0 0\nv 1 2 z\n"), "line 2: expected a number, found 'z'");
  EXPECT_EQ(read_error("obj", "#\\\nv 0 \\\n\\\n0 -1e999\n"),
            "line 4: expected a number that fits a double, found '-1e999'");
}

TEST(ReadObj, NamesBadFaces) {
  const auto error = [](const std::string& line) {
    return read_error("obj", kVertices + "f 1 2 3\n" + line + "\nf 1 2 3\n");
  };
  EXPECT_EQ(error("f 1 2 5"),
            "line 6: vertex index 5 is out of range, there are 4 vertices counted from 1");
  EXPECT_EQ(error("f 1 2 9\nf 1 2 5"),
            "line 6: vertex index 9 is out of range, there are 4 vertices counted from 1");
  EXPECT_EQ(error("f 0 1 2"),
            "line 6: vertex index 0 is out of range, vertices are counted from 1");
  EXPECT_EQ(error("f 1 2 -5"),
            "line 6: vertex index -5 is out of range, 4 vertices stand before it");
  EXPECT_EQ(
      error("f 1 2 -9223372036854775808"),
      "line 6: vertex index -9223372036854775808 is out of range, 4 vertices stand before it");
  EXPECT_EQ(
      error("f 1 2 9223372036854775807"),
      "line 6: vertex index 9223372036854775807 is out of range, there are 4 vertices counted "
      "from 1");
  EXPECT_EQ(error("f 1 2 9223372036854775808"),
            "line 6: expected an integer of at most 64 bits, found '9223372036854775808'");
  EXPECT_EQ(error("f 1 2 3x"), "line 6: expected an integer, found '3x'");
  EXPECT_EQ(error("f 1 2 /3"), "line 6: expected an integer, found '/3'");
  EXPECT_EQ(error("f 1.0 2 3"), "line 6: expected an integer, found '1.0'");
}

TEST(ReadObj, NamesWhatIsMissing) {
  EXPECT_EQ(read_error("obj",
                       "\x7f"
                       "ELF\x02\x01\x01"),
            "the mesh has no vertices");
  EXPECT_EQ(read_error("obj", kVertices), "the mesh has no faces");
  EXPECT_EQ(read_error("obj", "f 1 2 3"),
            "line 1: vertex index 3 is out of range, there are 0 vertices counted from 1");
}

}  // namespace
}  // namespace isomatch
