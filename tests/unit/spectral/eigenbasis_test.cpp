// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/eigenbasis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/cotangent_laplacian.h"
#include "support/mesh_files.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch::spectral {
namespace {

using std::numbers::pi;

/// A sphere of unit area up to its coarseness.
Mesh unit_sphere() { return test::icosphere(3, 1 / std::sqrt(4 * pi)); }

Eigen::VectorXd masses(const Mesh& mesh) {
  const std::vector<double> areas = vertex_areas(mesh);
  return Eigen::Map<const Eigen::VectorXd>(areas.data(), mesh.num_vertices());
}

void expect_orthonormal(const Mesh& mesh, const Eigenbasis& basis) {
  const Eigen::MatrixXd functions = basis.functions.cast<double>();
  const Eigen::MatrixXd products = functions.transpose() * masses(mesh).asDiagonal() * functions;
  const auto size = basis.values.size();
  EXPECT_LT((products - Eigen::MatrixXd::Identity(size, size)).lpNorm<Eigen::Infinity>(), 1e-4);
}

TEST(Eigenbasis, OfASphereHasItsEigenvalues) {
  constexpr int kDegrees = 5;
  const Eigenbasis basis = eigenbasis(unit_sphere(), kDegrees * kDegrees);
  for (int k = 0, degree = 0; degree < kDegrees; ++degree) {
    // Linear elements are off by some value * edge^2 / 12, here up to 3 %; half of that measured.
    const double value = degree * (degree + 1) * 4 * pi;
    for (int order = -degree; order <= degree; ++order, ++k)
      EXPECT_NEAR(basis.values[k], value, 0.03 * value + 1e-6) << k;
  }
}

TEST(Eigenbasis, OfASquareHasItsEigenvalues) {
  std::vector<double> expected;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) expected.push_back(pi * pi * (i * i + j * j));
  std::ranges::sort(expected);
  const Eigenbasis basis = eigenbasis(test::sheet(30, 30), 15);
  for (int k = 0; k < 15; ++k)
    EXPECT_NEAR(basis.values[k], expected[k], 0.03 * expected[k] + 1e-6) << k;
}

TEST(Eigenbasis, SolvesTheEigenproblem) {
  const Mesh mesh = test::rough_sphere(3, 0.1, 1);
  const Eigenbasis basis = eigenbasis(mesh, 30);
  EXPECT_TRUE(std::ranges::is_sorted(basis.values));
  expect_orthonormal(mesh, basis);
  const auto laplacian = cotangent_laplacian(mesh);
  for (int k = 0; k < 30; ++k) {
    const Eigen::VectorXd function = basis.functions.col(k).cast<double>();
    const Eigen::VectorXd image = laplacian * function;
    const Eigen::VectorXd expected = basis.values[k] * masses(mesh).cwiseProduct(function);
    EXPECT_LT((image - expected).norm(), 1e-3 * (1 + image.norm())) << k;
  }
}

TEST(Eigenbasis, BeginsWithTheConstant) {
  const Mesh mesh = test::scaled(unit_sphere(), 3);
  const Eigenbasis basis = eigenbasis(mesh, 10);
  EXPECT_NEAR(basis.values[0], 0, 1e-6);
  const double value = 1 / std::sqrt(surface_area(mesh));
  for (int v = 0; v < mesh.num_vertices(); ++v)
    EXPECT_NEAR(std::abs(basis.functions(v, 0)), value, 1e-3 * value);
}

TEST(Eigenbasis, ValuesAreInUnitsOfOneOverArea) {
  const Mesh mesh = test::rough_sphere(2, 0.1, 1);
  const Eigenbasis small = eigenbasis(mesh, 20), large = eigenbasis(test::scaled(mesh, 50), 20);
  for (int k = 1; k < 20; ++k)
    EXPECT_NEAR(2500 * large.values[k], small.values[k], 1e-4 * small.values[k]);
}

TEST(Eigenbasis, OfTinyMeshesHasFewerFunctions) {
  const Mesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  for (const Mesh& mesh : {triangle, test::tetrahedron(), test::icosphere(0)}) {
    const Eigenbasis basis = eigenbasis(mesh, 100);
    EXPECT_GE(basis.values.size(), 2);
    EXPECT_LE(basis.values.size(), mesh.num_vertices());
    EXPECT_EQ(basis.functions.cols(), basis.values.size());
    EXPECT_EQ(basis.functions.rows(), mesh.num_vertices());
    EXPECT_NEAR(basis.values[0], 0, 1e-6);
    expect_orthonormal(mesh, basis);
  }
}

TEST(Eigenbasis, IsTheSameEveryTime) {
  const Mesh mesh = test::rough_sphere(2, 0.1, 1);
  const Eigenbasis first = eigenbasis(mesh, 20), second = eigenbasis(mesh, 20);
  EXPECT_EQ(first.functions, second.functions);
  EXPECT_EQ(first.values, second.values);
}

TEST(Eigenbasis, ExistsOnNonManifoldMeshes) {
  for (const Mesh& mesh : {test::sphere_with_fin(), test::bow_tie(), test::moebius_strip(24)}) {
    const Eigenbasis basis = eigenbasis(mesh, 20);
    EXPECT_EQ(basis.values.size(), 20);
    expect_orthonormal(mesh, basis);
  }
}

}  // namespace
}  // namespace isomatch::spectral
