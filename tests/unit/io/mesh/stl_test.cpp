// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <string>

#include "support/mesh_files.h"

namespace isomatch {
namespace {

using test::bytes;
using test::read_content;
using test::read_error;

constexpr auto kLittle = std::endian::little;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

using Triangle = std::array<Point, 3>;

/// Two triangles that share an edge. Each corner is named by its position alone.
const std::vector<Triangle> kTwo = {Triangle{Point(0, 0, 0), Point(1.5, 0, 0), Point(0, -0.25, 0)},
                                    Triangle{Point(0, -0.25, 0), Point(1.5, 0, 0), Point(1, 1, 8)}};
const std::vector<Point> kTwoVertices = {Point(0, 0, 0), Point(1.5, 0, 0), Point(0, -0.25, 0),
                                         Point(1, 1, 8)};
const std::vector<Face> kTwoFaces = {{0, 1, 2}, {2, 1, 3}};

std::string binary_stl(const std::vector<Triangle>& triangles, std::string text = "made by hand") {
  text.resize(80, '\0');
  std::string content = text + bytes(kLittle, {static_cast<std::uint32_t>(triangles.size())});
  for (const Triangle& triangle : triangles) {
    content += bytes<float>(kLittle, {kNan, kNan, kNan});
    for (const Point& p : triangle)
      for (const double coordinate : p) content += bytes(kLittle, {static_cast<float>(coordinate)});
    content += bytes<std::uint16_t>(kLittle, {0xffff});
  }
  return content;
}

std::string facet(const std::string& vertices) {
  return " facet normal 0 nan 1\n  outer loop\n" + vertices + "  endloop\n endfacet\n";
}

const std::string kFirst = facet("   vertex 0 0 0\n   vertex 1.5 0 0\n   vertex 0 -0.25 0\n");
const std::string kSecond = facet("   vertex 0 -2.5e-1 0\n   vertex 1.5 0 0\n   vertex 1 1 8\n");

void expect_two_triangles(const std::string& content) {
  SCOPED_TRACE(content);
  MeshReadReport report;
  const Mesh mesh = read_content("stl", content, &report);
  EXPECT_EQ(mesh.vertices, kTwoVertices);
  EXPECT_EQ(mesh.faces, kTwoFaces);
  EXPECT_EQ(report.merged_vertices, 2);
}

TEST(ReadStl, TakesBinary) { expect_two_triangles(binary_stl(kTwo)); }

TEST(ReadStl, TakesBinaryThatBeginsWithSolid) {
  expect_two_triangles(binary_stl(kTwo, "solid made by hand"));
  expect_two_triangles(binary_stl(kTwo, "solid" + std::string(75, ' ')));
}

TEST(ReadStl, TakesAscii) {
  expect_two_triangles("solid a name\n" + kFirst + kSecond + "endsolid a name\n");
  expect_two_triangles("\xef\xbb\xbf\n solid\r\n" + kFirst + kSecond + "endsolid");
  expect_two_triangles("solid facet\n" + kFirst + "endsolid\n\nsolid\n" + kSecond + "endsolid b\n");
}

TEST(ReadStl, TakesAsciiInUpperCaseAndAnyLayout) {
  std::string content;
  for (const char c : kFirst + kSecond)
    content += c == '\n' ? ' ' : static_cast<char>(std::toupper(c));
  expect_two_triangles("SOLID\n" + content + "ENDSOLID");
  content.clear();
  for (const char c : kFirst + kSecond) content += c == ' ' ? '\n' : c;
  expect_two_triangles("solid\n" + content + "endsolid");
}

TEST(ReadStl, TakesAsciiShorterThanABinaryHeader) {
  EXPECT_EQ(read_error("stl", "solid\nendsolid\n"), "the mesh has no vertices");
}

TEST(ReadStl, MergesMinusZeroWithZeroAndKeepsTheFirst) {
  const Mesh mesh = read_content(
      "stl", binary_stl({Triangle{Point(-0.0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)},
                         Triangle{Point(0, -0.0, 0), Point(0, 1, -0.0), Point(2, 2, 2)}}));
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(std::signbit(mesh.vertices[0].x()));
}

TEST(ReadStl, MergesNothingElse) {
  const float next = std::nextafter(1.0F, 2.0F);
  const Mesh mesh = read_content(
      "stl", binary_stl({Triangle{Point(1, 0, 0), Point(next, 0, 0), Point(0, 1, 0)}}));
  EXPECT_EQ(mesh.num_vertices(), 3);
}

TEST(ReadStl, MergesAsAnOrderedMapWould) {
  std::mt19937 random(5);
  const auto coordinate = [&] { return static_cast<double>(static_cast<int>(random() % 9) - 4); };
  std::vector<Triangle> triangles(3000);
  for (Triangle& triangle : triangles)
    for (Point& p : triangle) p = Point(coordinate(), coordinate(), coordinate());
  const Mesh mesh = read_content("stl", binary_stl(triangles));

  std::map<std::array<double, 3>, int> numbers;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const Point& p = triangles[f][corner];
      const int expected =
          numbers.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(numbers.size()))
              .first->second;
      ASSERT_EQ(mesh.faces[f][corner], expected);
      ASSERT_EQ(mesh.vertices[expected], p);
    }
  }
  EXPECT_EQ(mesh.vertices.size(), numbers.size());
}

TEST(ReadStl, NamesBadBinaryFiles) {
  const std::string good = binary_stl(kTwo);
  const auto with = [&](std::size_t at, const std::string& value) {
    return std::string(good).replace(at, value.size(), value);
  };
  EXPECT_EQ(read_error("stl", "short"),
            "too short for a binary STL file, and an ASCII one begins with solid");
  EXPECT_EQ(read_error("stl", with(80, bytes<std::uint32_t>(kLittle, {3}))),
            "byte 80: 3 triangles announced, more than the 100 bytes that follow can hold");
  EXPECT_EQ(
      read_error("stl", with(80, bytes<std::uint32_t>(kLittle, {0xffffffff}))),
      "byte 80: 4294967295 triangles announced, more than the 100 bytes that follow can hold");
  EXPECT_EQ(read_error("stl", with(80, bytes<std::uint32_t>(kLittle, {1}))),
            "byte 134: more bytes follow than the file announces");
  EXPECT_EQ(read_error("stl", good.substr(0, good.size() - 1)),
            "byte 80: 2 triangles announced, more than the 99 bytes that follow can hold");
  EXPECT_EQ(read_error("stl", binary_stl(kTwo, "solid").substr(0, 183)),
            "byte 80: 2 triangles announced, more than the 99 bytes that follow can hold");
  EXPECT_EQ(read_error("stl", binary_stl({})), "the mesh has no vertices");
}

TEST(ReadStl, NamesBadAsciiFiles) {
  const auto error = [](const std::string& content) {
    return read_error("stl", "solid\n" + content);
  };
  EXPECT_EQ(error(kFirst), "line 9: the file ends before endsolid");
  EXPECT_EQ(error(kFirst + "endsolid\nfoo"), "line 10: expected solid, found 'foo'");
  EXPECT_EQ(error(kFirst + "face"), "line 9: expected facet or endsolid, found 'face'");
  EXPECT_EQ(error("facet norm"), "line 2: expected normal, found 'norm'");
  EXPECT_EQ(error("facet normal 0 0 1"), "line 2: the file ends before endsolid");
  EXPECT_EQ(error(facet("vertex 0 0 0\nvertex 0 0 1\n")),
            "line 6: expected vertex, found 'endloop'");
  EXPECT_EQ(error(facet("vertex 0 0 0\nvertex 0 0 1\nvertex 0 1 1\nvertex 1 1 1\n")),
            "line 7: expected endloop, found 'vertex'");
  EXPECT_EQ(error(facet("vertex 0 0 0\nvertex 0 0 1e999\n")),
            "line 5: expected a number that fits a double, found '1e999'");
  EXPECT_EQ(error(facet("vertex 0 0 0\nvertex 0 0\n")),
            "line 6: expected a number, found 'endloop'");
  EXPECT_EQ(error("facet normal 0 0 1 outer loop vertex 0 0"),
            "line 2: expected a number, but the line ends");
}

}  // namespace
}  // namespace isomatch
