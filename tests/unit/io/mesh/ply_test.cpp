// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include "support/mesh_files.h"

namespace isomatch {
namespace {

using test::bytes;
using test::read_content;
using test::read_error;
using test::tetrahedron;

constexpr auto kLittle = std::endian::little;
constexpr auto kBig = std::endian::big;

const std::string kAsciiHeader =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kAsciiVertices = "0 0 0\n1.5 0 0\n0 2 0\n0 0 -0.25\n";
const std::string kAsciiFaces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

/// Header of a binary file of `vertices` float vertices and `faces` faces; 208 bytes and the
/// digits.
std::string binary_header(std::endian order, int vertices, int faces) {
  return "ply\nformat binary_" + std::string(order == kLittle ? "little" : "big") +
         "_endian 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string triangle(std::endian order, int a, int b, int c) {
  return bytes<std::uint8_t>(order, {3}) + bytes<std::int32_t>(order, {a, b, c});
}

std::string one_triangle(std::endian order = kLittle) {
  return binary_header(order, 3, 1) + bytes<float>(order, {0, 0, 0, 1, 0, 0, 0, 1, 0}) +
         triangle(order, 0, 1, 2);
}

void expect_tetrahedron(const std::string& content) {
  SCOPED_TRACE(content);
  const Mesh mesh = read_content("ply", content);
  EXPECT_EQ(mesh.vertices, tetrahedron().vertices);
  EXPECT_EQ(mesh.faces, tetrahedron().faces);
}

TEST(ReadPly, TakesAscii) {
  const std::string content = kAsciiHeader + kAsciiVertices + kAsciiFaces;
  expect_tetrahedron(content);
  expect_tetrahedron("\xef\xbb\xbf" + content);
  for (const std::string end : {"\r\n", "\r", " \n\n"}) {
    std::string changed;
    for (const char c : content) changed += c == '\n' ? end : std::string(1, c);
    expect_tetrahedron(changed);
  }
}

TEST(ReadPly, TakesBothByteOrders) {
  for (const std::endian order : {kLittle, kBig}) {
    expect_tetrahedron(binary_header(order, 4, 4) +
                       bytes<float>(order, {0, 0, 0, 1.5F, 0, 0, 0, 2, 0, 0, 0, -0.25F}) +
                       triangle(order, 0, 2, 1) + triangle(order, 0, 1, 3) +
                       triangle(order, 1, 2, 3) + triangle(order, 2, 0, 3));
  }
}

TEST(ReadPly, BinaryDataMayBeginWithALineEnd) {
  // 1.40129846e-44 is the float of the bytes 0a 00 00 00.
  std::string content = one_triangle();
  const std::size_t body = content.find("end_header\n") + 11;
  content[body] = '\n';
  EXPECT_EQ(read_content("ply", content).vertices[0], Point(std::bit_cast<float>(10), 0, 0));
  content.insert(body - 1, "\r");
  EXPECT_EQ(read_content("ply", content).vertices[0], Point(std::bit_cast<float>(10), 0, 0));
}

TEST(ReadPly, PassesOverCommentsAndObjectInformation) {
  std::string content = kAsciiHeader + kAsciiVertices + kAsciiFaces;
  content.insert(4, "comment made by hand\ncomment\nobj_info num_cols 3\n");
  content.insert(content.find("end_header"), "comment element vertex 9\nobj_info end_header\n");
  expect_tetrahedron(content);
}

/// A file of one triangle between elements and properties that are passed over, in the value types
/// T of coordinates and L of list lengths and indices.
template <class T, class L>
std::string crowded_file(std::endian order, const std::string& number, const std::string& index) {
  std::string content = std::string("ply\nformat ") +
                        (order == kLittle ? "binary_little_endian" : "binary_big_endian") +
                        " 1.0\nelement camera 2\nproperty short id\nproperty list char float rows\n"
                        "element vertex 3\nproperty uchar red\nproperty list " +
                        index + " " + number + " weights\nproperty " + number + " z\nproperty " +
                        number + " x\nproperty double quality\nproperty " + number +
                        " y\nproperty list uchar short after\n"
                        "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
                        "element face 1\nproperty uchar flags\nproperty list uchar float texcoord\n"
                        "property list " +
                        index + " " + index +
                        " vertex_index\nproperty double last\n"
                        "element tail 1\nproperty float value\nend_header\n";
  content += bytes<std::int16_t>(order, {5}) + bytes<std::int8_t>(order, {0});
  content += bytes<std::int16_t>(order, {6}) + bytes<std::int8_t>(order, {2}) +
             bytes<float>(order, {1, 2});
  for (const T v : {T{0}, T{1}, T{2}})
    content += bytes<std::uint8_t>(order, {200}) + bytes<L>(order, {2}) + bytes<T>(order, {7, 7}) +
               bytes<T>(order, {static_cast<T>(v * 3), v}) +
               bytes<double>(order, {std::numeric_limits<double>::quiet_NaN()}) +
               bytes<T>(order, {static_cast<T>(v * v)}) + bytes<std::uint8_t>(order, {1}) +
               bytes<std::int16_t>(order, {-1});
  content += bytes<std::int32_t>(order, {0, 1});
  content += bytes<std::uint8_t>(order, {1, 1}) + bytes<float>(order, {0.5F}) +
             bytes<L>(order, {3, 2, 0, 1}) + bytes<double>(order, {0});
  return content + bytes<float>(order, {1});
}

void expect_crowded_triangle(const std::string& content) {
  SCOPED_TRACE(content.substr(0, content.find("end_header")));
  const Mesh mesh = read_content("ply", content);
  EXPECT_EQ(mesh.vertices, (std::vector{Point(0, 0, 0), Point(1, 1, 3), Point(2, 4, 6)}));
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{2, 0, 1}}));
}

TEST(ReadPly, TakesAnyTypesOrderAndFurtherElements) {
  for (const std::endian order : {kLittle, kBig}) {
    expect_crowded_triangle(crowded_file<float, std::uint8_t>(order, "float", "uchar"));
    expect_crowded_triangle(crowded_file<double, std::int8_t>(order, "double", "char"));
    expect_crowded_triangle(crowded_file<std::int8_t, std::uint16_t>(order, "int8", "uint16"));
    expect_crowded_triangle(crowded_file<std::uint8_t, std::int16_t>(order, "uint8", "int16"));
    expect_crowded_triangle(crowded_file<std::int16_t, std::uint32_t>(order, "short", "uint"));
    expect_crowded_triangle(crowded_file<std::uint16_t, std::int32_t>(order, "ushort", "int"));
    expect_crowded_triangle(crowded_file<std::int32_t, float>(order, "int32", "float32"));
    expect_crowded_triangle(crowded_file<std::uint32_t, double>(order, "uint32", "float64"));
  }
}

TEST(ReadPly, TakesAnyOrderInAscii) {
  expect_crowded_triangle(
      "ply\nformat ascii 1.0\nelement camera 2\nproperty short id\nproperty list char float rows\n"
      "element face 1\nproperty list uchar float texcoord\n"
      "property list int uint vertex_indices\nproperty uchar flags\n"
      "element vertex 3\nproperty list uchar int weights\nproperty float z\nproperty int x\n"
      "property float nx\nproperty double y\nend_header\n"
      "5 0\n6 2 nan 1\n2 0.5 0.5 3 2 0 1 255\n0 0 0 nan 0\n2 8 9 3 1 -inf 1\n1 9 6 2 x 4e0\n");
}

TEST(ReadPly, CutsPolygonsIntoFans) {
  MeshReadReport report;
  std::string content = kAsciiHeader + kAsciiVertices + "4 0 1 2 3\n3 0 1 2\n4 3 2 1 0\n3 0 1 2\n";
  const Mesh mesh = read_content("ply", content, &report);
  EXPECT_EQ(mesh.faces,
            (std::vector<Face>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {3, 2, 1}, {3, 1, 0}, {0, 1, 2}}));
  EXPECT_EQ(report.triangulated_polygons, 2);
}

TEST(ReadPly, TakesTriangleStrips) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 2\nproperty list int int vertex_indices\nend_header\n";
  // The repeated 2 steers the strip: the triangles with it are none.
  const Mesh mesh =
      read_content("ply", header + kAsciiVertices + "13 0 1 2 3 -1 3 2 -1 0 1 2 2 3\n3 3 2 1\n");
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {2, 1, 3}, {0, 1, 2}, {3, 2, 1}}));
  EXPECT_EQ(read_error("ply", header + kAsciiVertices + "3 0 1 -2\n1 0\n"),
            "line 14: vertex index -2 is out of range, there are 4 vertices counted from 0");
}

TEST(ReadPly, NamesBadHeaders) {
  const auto error = [](const std::string& lines) {
    return read_error("ply", "ply\nformat ascii 1.0\n" + lines);
  };
  EXPECT_EQ(read_error("ply", "plyx\n"), "line 1: expected ply, found 'plyx'");
  EXPECT_EQ(read_error("ply", "\nply\n"), "line 1: expected ply, found ''");
  EXPECT_EQ(read_error("ply", "ply\nformat utf8 1.0\n"), "line 2: unknown format 'utf8'");
  EXPECT_EQ(read_error("ply", "ply\nformat ascii 2.0\n"),
            "line 2: unknown version '2.0' of the format");
  EXPECT_EQ(read_error("ply", "ply\nelement vertex 0\nend_header\n"),
            "line 4: the header does not name the format");
  EXPECT_EQ(error("element vertex\n"), "line 3: expected an integer, but the line ends");
  EXPECT_EQ(error("element vertex three\n"), "line 3: expected an integer, found 'three'");
  EXPECT_EQ(error("element vertex 0 0\n"), "line 3: expected the end of the line, found '0'");
  EXPECT_EQ(error("property float x\n"), "line 3: a property stands before the first element");
  EXPECT_EQ(error("element a 0\nproperty float\n"), "line 4: the property has no name");
  EXPECT_EQ(error("element a 0\nproperty half x\n"), "line 4: unknown type 'half'");
  EXPECT_EQ(error("element a 0\nproperty list uchar\n"), "line 4: unknown type ''");
  EXPECT_EQ(error("elephant 3\n"), "line 3: unknown keyword 'elephant' in the header");
  EXPECT_EQ(error("element a 0\n"), "line 4: the file ends before end_header");
  EXPECT_EQ(error("element vertex 0\nelement vertex 0\nend_header\n"),
            "line 4: a second element called 'vertex'");
  EXPECT_EQ(error("element a 1\nend_header\n1\n"), "line 3: element 'a' has no properties");
}

TEST(ReadPly, NamesMissingProperties) {
  const auto error = [](const std::string& lines) {
    return read_error("ply", "ply\nformat ascii 1.0\n" + lines + "end_header\n3 0 0\n3 0 0 0\n");
  };
  EXPECT_EQ(error("element vertex 1\nproperty int x\nproperty int y\nproperty list int int z\n"),
            "line 3: element 'vertex' has no property z");
  EXPECT_EQ(error("element vertex 1\nproperty int x\nproperty int y\nproperty int z\n"
                  "element face 1\nproperty int vertex_indices\n"),
            "line 7: element 'face' has no property list vertex_indices");
}

TEST(ReadPly, NamesCountsThatCannotBe) {
  const auto error = [](const std::string& vertices, const std::string& faces) {
    return read_error(
        "ply", "ply\nformat binary_little_endian 1.0\nelement vertex " + vertices +
                   "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
                   "\nproperty list uchar int vertex_indices\nend_header\n" +
                   bytes<float>(kLittle, {0, 0, 0, 1, 0, 0, 0, 1, 0}) + triangle(kLittle, 0, 1, 2));
  };
  EXPECT_EQ(error("3", "1"), "no error");
  EXPECT_EQ(error("5", "1"),
            "line 3: 5 'vertex' elements announced, more than the 49 bytes that follow can hold");
  EXPECT_EQ(error("3", "50"),
            "line 7: 50 'face' elements announced, more than the 49 bytes that follow can hold");
  EXPECT_EQ(
      error("4000000000", "1"),
      "line 3: 4000000000 'vertex' elements announced, more than the 177 bytes that follow can "
      "hold");
  EXPECT_EQ(error("3", "-1"), "line 7: the number of 'face' elements is negative (-1)");
  EXPECT_EQ(error("0", "0"), "the mesh has no vertices");
}

TEST(ReadPly, NamesBadAsciiValues) {
  const std::string rest = kAsciiVertices.substr(6);
  EXPECT_EQ(read_error("ply", kAsciiHeader + "0 0\n" + rest + kAsciiFaces),
            "line 10: expected a number, but the line ends");
  EXPECT_EQ(read_error("ply", kAsciiHeader + "0 0 0 0\n" + rest + kAsciiFaces),
            "line 10: expected the end of the line, found '0'");
  EXPECT_EQ(read_error("ply", kAsciiHeader + "0 1e999 0\n" + rest + kAsciiFaces),
            "line 10: expected a number that fits a double, found '1e999'");
  EXPECT_EQ(read_error("ply", kAsciiHeader + kAsciiVertices + "3 0 1 4\n" + kAsciiFaces),
            "line 14: vertex index 4 is out of range, there are 4 vertices counted from 0");
  EXPECT_EQ(read_error("ply", kAsciiHeader + kAsciiVertices + "2 0 1 4\n" + kAsciiFaces),
            "line 14: expected the end of the line, found '4'");
  EXPECT_EQ(read_error("ply", kAsciiHeader + kAsciiVertices + "-3 0 1 4\n" + kAsciiFaces),
            "line 14: a list of -3 entries");
  EXPECT_EQ(read_error("ply", kAsciiHeader + kAsciiVertices + "9999999999 0 1\n" + kAsciiFaces),
            "line 14: expected an integer, but the line ends");
  EXPECT_EQ(read_error("ply", kAsciiHeader + kAsciiVertices + "3 0 1 2\n3 0 1 2\n3 0 1 2"),
            "line 16: the file ends after 3 of 4 elements 'face'");
}

TEST(ReadPly, NamesBadBinaryValues) {
  const std::size_t body = binary_header(kLittle, 3, 1).size();
  const std::string good = one_triangle();
  const auto error = [&](std::size_t at, const std::string& value) {
    return read_error("ply", std::string(good).replace(body + at, value.size(), value));
  };
  const auto place = [&](std::size_t at) { return "byte " + std::to_string(body + at) + ": "; };
  EXPECT_EQ(error(36, "\x02"), "the mesh has no faces");
  EXPECT_EQ(error(36, "\xff"), place(49) + "the file ends too early");
  EXPECT_EQ(error(41, bytes<std::int32_t>(kLittle, {-1})),
            place(41) + "vertex index -1 is out of range, there are 3 vertices counted from 0");
  EXPECT_EQ(error(45, bytes<std::int32_t>(kLittle, {3})),
            place(45) + "vertex index 3 is out of range, there are 3 vertices counted from 0");
  EXPECT_EQ(read_error("ply", good.substr(0, good.size() - 1)),
            place(45) + "the file ends too early");
}

TEST(ReadPly, TakesWholeNumbersWithPointsForIntegers) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\nproperty int y\n"
      "property short z\nproperty uchar red\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  const std::string points = "0 0 0 200.0\n1.0 0 0 2e2\n0 1 -1.0 0\n";
  const Mesh mesh = read_content("ply", header + points + "3.0 0 1.0 2\n");
  EXPECT_EQ(mesh.vertices[2], Point(0, 1, -1));
  EXPECT_EQ(mesh.faces[0], (Face{0, 1, 2}));
  EXPECT_EQ(read_error("ply", header + points + "3 0 1.5 2\n"),
            "line 14: expected an integer, found '1.5'");
  EXPECT_EQ(read_error("ply", header + "0.5 0 0 0\n" + points),
            "line 11: expected an integer, found '0.5'");
}

TEST(ReadPly, WhatFollowsTheEndIsAWarning) {
  const std::string ascii = kAsciiHeader + kAsciiVertices + kAsciiFaces;
  MeshReadReport report;
  for (const char* more : {"\n", " \n\n"}) {
    read_content("ply", ascii + more, &report);
    EXPECT_THAT(report.warnings, testing::IsEmpty());
  }
  EXPECT_EQ(read_content("ply", ascii + "\n3 0 1 2", &report).faces,
            read_content("ply", ascii).faces);
  EXPECT_EQ(report.warnings.size(), 1U);
  const Mesh mesh = read_content("ply", one_triangle() + "\n", &report);
  EXPECT_EQ(mesh.num_faces(), 1);
  EXPECT_EQ(report.warnings.size(), 1U);
}

TEST(ReadPly, NamesFractionalIndices) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list float double vertex_indices\nend_header\n";
  EXPECT_EQ(read_content("ply", header + kAsciiVertices + "3.0 0 1 2e0\n").faces[0],
            (Face{0, 1, 2}));
  EXPECT_EQ(read_error("ply", header + kAsciiVertices + "3 0 1 1.5\n"),
            "line 14: expected a whole number, found 1.5");
  EXPECT_EQ(read_error("ply", header + kAsciiVertices + "1e300 0 1 1.5\n"),
            "line 14: expected a whole number, found 1e+300");
}

}  // namespace
}  // namespace isomatch
