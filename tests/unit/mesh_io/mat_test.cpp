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
  auto coordinates = kCoordinates;
  coordinates[3] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(error(kMat.matrix("VERT", 4, 3, coordinates) + triangles()), HasSubstr("not finite"));
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
