// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/cotangent_laplacian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/random.h"
#include "support/rough_meshes.h"
#include "support/shapes.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

using Laplacian = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using std::numbers::pi;

constexpr double kRounding = 1e-12;
constexpr int kCells = 6;

int sheet_vertex(int column, int row) { return row * (kCells + 1) + column; }

/// A sheet sheared so that all triangles are equilateral.
Mesh equilateral_sheet() {
  Mesh mesh = test::sheet(kCells, kCells, kCells, kCells);
  for (Point& p : mesh.vertices) p = Point(p.x() - p.y() / 2, p.y() * std::sqrt(0.75), 0);
  return mesh;
}

double energy(const Laplacian& laplacian, const Eigen::VectorXd& function) {
  return function.dot(laplacian * function);
}

TEST(CornerAngle, OfKnownTriangles) {
  const Mesh mesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {4, 0, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  EXPECT_NEAR(corner_angle(mesh, mesh.faces[0], 0), pi / 2, kRounding);
  EXPECT_NEAR(corner_angle(mesh, mesh.faces[0], 1), pi / 4, kRounding);
  EXPECT_NEAR(corner_angle(mesh, mesh.faces[1], 0), 0, kRounding);
  EXPECT_NEAR(corner_angle(mesh, mesh.faces[1], 1), pi, kRounding);
}

TEST(CotangentLaplacian, OfEquilateralTrianglesIsUniform) {
  const Laplacian laplacian = cotangent_laplacian(equilateral_sheet());
  const int centre = sheet_vertex(3, 3);
  const double cotangent = 1 / std::sqrt(3.0);
  for (const auto& [column, row] : {std::pair{2, 3}, {4, 3}, {3, 2}, {3, 4}, {4, 4}, {2, 2}})
    EXPECT_NEAR(laplacian.coeff(centre, sheet_vertex(column, row)), -cotangent, kRounding);
  EXPECT_NEAR(laplacian.coeff(centre, centre), 6 * cotangent, kRounding);
  // On the boundary there is only one triangle.
  EXPECT_NEAR(laplacian.coeff(sheet_vertex(2, 0), sheet_vertex(3, 0)), -cotangent / 2, kRounding);
}

TEST(CotangentLaplacian, OfASquareGridIsTheFivePointStencil) {
  const Laplacian laplacian = cotangent_laplacian(test::sheet(kCells, kCells));
  const int centre = sheet_vertex(3, 3);
  for (const auto& [column, row] : {std::pair{2, 3}, {4, 3}, {3, 2}, {3, 4}})
    EXPECT_NEAR(laplacian.coeff(centre, sheet_vertex(column, row)), -1, kRounding);
  EXPECT_NEAR(laplacian.coeff(centre, sheet_vertex(4, 4)), 0, kRounding);
  EXPECT_NEAR(laplacian.coeff(centre, centre), 4, kRounding);
}

TEST(CotangentLaplacian, GivesTheDirichletEnergyOfALinearFunction) {
  const Mesh mesh = test::sheet(kCells, kCells, 3, 2);
  Eigen::VectorXd function(mesh.num_vertices());
  for (int v = 0; v < mesh.num_vertices(); ++v)
    function[v] = 2 * mesh.vertices[v].x() - mesh.vertices[v].y() + 7;
  EXPECT_NEAR(energy(cotangent_laplacian(mesh), function), 6 * (2 * 2 + 1 * 1), 1e-10);
}

class CotangentLaplacianOf : public testing::TestWithParam<test::ZooMesh> {};

TEST_P(CotangentLaplacianOf, IsSymmetricPositiveAndKeepsConstants) {
  const Mesh& mesh = GetParam().mesh;
  const Laplacian laplacian = cotangent_laplacian(mesh);
  ASSERT_EQ(laplacian.rows(), mesh.num_vertices());
  const Laplacian transposed = laplacian.transpose();
  EXPECT_EQ((transposed - laplacian).norm(), 0);
  const Eigen::VectorXd row_sums = laplacian * Eigen::VectorXd::Ones(mesh.num_vertices());
  EXPECT_LT(row_sums.lpNorm<Eigen::Infinity>(), 1e-10);
  test::Random random(1);
  Eigen::VectorXd function(mesh.num_vertices());
  for (int trial = 0; trial < 10; ++trial) {
    for (double& value : function) value = random.uniform(-1, 1);
    EXPECT_GE(energy(laplacian, function), -kRounding);
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, CotangentLaplacianOf, testing::ValuesIn(test::mesh_zoo()),
                         [](const auto& test) { return test.param.name; });

TEST(CotangentLaplacian, BoundsTheWeightsOfSlivers) {
  const Laplacian laplacian = cotangent_laplacian(test::sliver_torus(30, 12, 1e-5, 1));
  for (int row = 0; row < laplacian.rows(); ++row) {
    for (Laplacian::InnerIterator entry(laplacian, row); entry; ++entry) {
      if (entry.col() == row) continue;
      EXPECT_LE(entry.value(), 0);
      EXPECT_GE(entry.value(), -2 * 10);  // Ten from the triangle on either side.
    }
  }
}

}  // namespace
}  // namespace isomatch
