// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/mat_files.h"
#include "support/mesh_files.h"

namespace isomatch {
namespace {

using test::MatWriter;
using test::read_content;
using test::read_error;
using test::tetrahedron;
using testing::HasSubstr;

const MatWriter kMat(std::endian::little);
const std::vector<double> kCoordinates = {0, 1.5, 0, 0, 0, 0, 2, 0, 0, 0, 0, -0.25};
const std::vector<double> kCorners = {1, 1, 2, 3, 3, 2, 3, 1, 2, 4, 4, 4};

std::string triangles(const std::vector<double>& corners = kCorners) {
  return kMat.matrix("TRIV", 4, 3, corners);
}

std::string error(const std::string& variables) {
  return read_error("mat", kMat.header() + variables);
}

void expect_tetrahedron(const std::string& content) {
  const Mesh mesh = read_content("mat", content);
  EXPECT_EQ(mesh.vertices, tetrahedron().vertices);
  EXPECT_EQ(mesh.faces, tetrahedron().faces);
}

TEST(Mat, StructsOfToscaInBothByteOrders) {
  for (const auto order : {std::endian::little, std::endian::big}) {
    const std::string plain = test::tetrahedron_mat(order);
    expect_tetrahedron(plain);
    expect_tetrahedron(plain.substr(0, 128) + MatWriter(order).compressed(plain.substr(128)));
  }
}

TEST(Mat, VariablesAtTopLevelAmongOthers) {
  expect_tetrahedron(kMat.header() + kMat.matrix("area", 1, 1, {5}) +
                     kMat.compressed(kMat.matrix("VERT", 4, 3, kCoordinates)) + triangles());
  expect_tetrahedron(kMat.header() + kMat.structure("other", {"a"}, {kMat.matrix("", 0, 0, {})}) +
                     kMat.matrix("X", 1, 4, {0, 1.5, 0, 0}) + triangles() +
                     kMat.matrix("Y", 4, 1, {0, 0, 2, 0}) +
                     kMat.matrix("Z", 4, 1, {0, 0, 0, -0.25}));
}

TEST(Mat, MatricesOfThreeRows) {
  expect_tetrahedron(kMat.header() +
                     kMat.matrix("VERT", 3, 4, {0, 0, 0, 1.5, 0, 0, 0, 2, 0, 0, 0, -0.25}) +
                     kMat.matrix("TRIV", 3, 4, {1, 3, 2, 1, 2, 4, 2, 3, 4, 3, 1, 4}));
}

/// The tetrahedron as a struct.
std::string shape(std::string_view name, const std::string& points = "VERT",
                  const std::string& corners = "TRIV") {
  return kMat.structure(name, {points, corners},
                        {kMat.matrix("", 4, 3, kCoordinates), kMat.matrix("", 4, 3, kCorners)});
}

TEST(Mat, StructsWithinStructs) {
  const std::string number = kMat.matrix("", 1, 1, {7});
  const std::string inner = kMat.structure("", {"id", "surface"}, {number, shape("")});
  expect_tetrahedron(kMat.header() + kMat.structure("S", {"surface", "n"}, {shape(""), number}));
  expect_tetrahedron(kMat.header() + kMat.structure("T", {"n", "S"}, {number, inner}));
  expect_tetrahedron(kMat.header() + kMat.compressed(kMat.structure("T", {"S"}, {inner})));
}

TEST(Mat, FacesAndVerticesOfPatches) {
  expect_tetrahedron(kMat.header() + shape("FV", "vertices", "faces"));
  expect_tetrahedron(kMat.header() + kMat.structure("S", {"FV"}, {shape("", "vertices", "faces")}));
  expect_tetrahedron(kMat.header() + kMat.byte_matrix("faces", 4, 3, kCorners) +
                     kMat.matrix("vertices", 4, 3, kCoordinates));
  auto corners = kCorners;
  corners[0] = 9;
  EXPECT_THAT(
      error(kMat.matrix("vertices", 4, 3, kCoordinates) + kMat.matrix("faces", 4, 3, corners)),
      HasSubstr("vertex 9 in faces is out of range"));
}

TEST(Mat, SeveralShapesAreNamed) {
  EXPECT_THAT(error(shape("cat") + shape("dog")), HasSubstr("2 shapes: cat, dog;"));
  EXPECT_THAT(error(kMat.structure("S", {"cat", "dog"}, {shape(""), shape("")})),
              HasSubstr("2 shapes: S.cat, S.dog;"));
  EXPECT_THAT(
      error(kMat.structure("S", {"VERT", "TRIV"},
                           {kMat.matrix("", 4, 3, kCoordinates), kMat.matrix("", 4, 3, kCorners),
                            kMat.matrix("", 4, 3, kCoordinates), kMat.matrix("", 4, 3, kCorners)})),
      HasSubstr("2 shapes: S(1), S(2);"));
  EXPECT_THAT(error(shape("cat") + kMat.matrix("VERT", 4, 3, kCoordinates) + triangles()),
              HasSubstr("2 shapes: the variables by themselves, cat;"));
  EXPECT_THAT(error(shape("a") + shape("b") + shape("c") + shape("d") + shape("e") + shape("f") +
                    shape("g")),
              HasSubstr("7 shapes: a, b, c, d, e, f, ...;"));
}

TEST(Mat, DeepNestingEnds) {
  std::string nested = shape("");
  for (int i = 0; i < 1000; ++i) nested = kMat.structure("", {"S"}, {nested});
  EXPECT_THAT(error(nested), HasSubstr("no shape"));
}

TEST(Mat, OtherFilesAreRefused) {
  std::string hdf = kMat.header();
  EXPECT_THAT(read_error("mat", "MATLAB 7.3 MAT-file" + hdf.substr(19)), HasSubstr("-v7"));
  EXPECT_THAT(read_error("mat", hdf.substr(0, 100)), HasSubstr("level 5"));
  EXPECT_THAT(read_error("mat", "v 0 0 0"), HasSubstr("level 5"));
  EXPECT_THAT(error(triangles()), HasSubstr("no shape"));
}

TEST(Mat, BadShapesAreRefused) {
  const std::string points = kMat.matrix("VERT", 4, 3, kCoordinates);
  auto corners = kCorners;
  for (const double bad : {0.0, 5.0, -1.0, 1.5, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    corners[5] = bad;
    EXPECT_THAT(error(points + triangles(corners)), HasSubstr("is out of range"));
  }
  EXPECT_THAT(error(kMat.matrix("VERT", 6, 2, kCoordinates) + triangles()),
              HasSubstr("three columns"));
  EXPECT_THAT(error(kMat.matrix("X", 4, 1, {1, 2, 3, 4}) + kMat.matrix("Y", 3, 1, {1, 2, 3}) +
                    kMat.matrix("Z", 4, 1, {1, 2, 3, 4}) + triangles()),
              HasSubstr("equally many"));
  EXPECT_THAT(error(kMat.matrix("VERT", 0, 3, {}) + kMat.matrix("TRIV", 0, 3, {})),
              HasSubstr("no vertices"));
}

TEST(Mat, HugeAnnouncementsAreRefused) {
  EXPECT_THAT(error(kMat.matrix("VERT", 2147483647, 3, kCoordinates)), HasSubstr("has 12 values"));
  std::string variable = triangles();
  variable.replace(4, 4, "\xff\xff\xff\x7f");
  EXPECT_THAT(error(variable), HasSubstr("2147483647 bytes announced"));
  EXPECT_THAT(error(kMat.compressed(variable)), HasSubstr("ends too early"));
}

}  // namespace
}  // namespace isomatch
