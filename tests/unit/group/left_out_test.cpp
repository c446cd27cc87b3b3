// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "group/left_out.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "support/random.h"

namespace isomatch {
namespace {

/// Parts of the shape along the axes of the others, the largest first.
std::vector<double> parts_by_eigenvectors(const Eigen::VectorXd& squares,
                                          const Eigen::VectorXd& shape, double factor) {
  Eigen::MatrixXd products = squares.asDiagonal();
  products -= factor * shape * shape.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(products);
  std::vector<double> parts;
  for (Eigen::Index k = squares.size(); k-- > 0;) {
    const double part = solver.eigenvectors().col(k).dot(shape);
    parts.push_back(part * part);
  }
  return parts;
}

void expect_same_parts(const Eigen::VectorXd& squares, const Eigen::VectorXd& shape,
                       double factor) {
  const std::vector<double> expected = parts_by_eigenvectors(squares, shape, factor);
  const std::vector<double> parts = LeftOut(squares, shape, factor).parts();
  ASSERT_EQ(parts.size(), expected.size());
  for (Eigen::Index k = 0; k < squares.size(); ++k)
    // The eigenvectors are rounded.
    EXPECT_NEAR(parts[k], expected[k], 1e-9 * shape.squaredNorm()) << k;
}

TEST(LeftOutShape, PartsAreThoseAlongTheEigenvectorsOfTheOthers) {
  test::Random random(1);
  for (const int size : {1, 2, 5, 40}) {
    Eigen::VectorXd squares(size), shape(size);
    for (double& square : squares) square = random.uniform(0.1, 10);
    std::ranges::sort(squares, std::greater());
    for (int k = 0; k < size; ++k) shape[k] = random.uniform(-1, 1) * std::sqrt(squares[k] / size);
    expect_same_parts(squares, shape, 1.1 / (1.1 + shape.squaredNorm()));
  }
}

TEST(LeftOutShape, ASharesNothingWithAxesThatItDoesNotChange) {
  const Eigen::Vector4d squares(4, 3, 2, 1), shape(0, 1, 0, 0.5);
  expect_same_parts(squares, shape, 1.2);
  // The second axis of the shape becomes the third of the others.
  expect_same_parts(squares, Eigen::Vector4d(0, 1.1, 0, 0.3), 1.2);
}

TEST(LeftOutShape, NeitherEqualNorNearlyEqualAxesAreInTheWay) {
  const Eigen::Vector4d shape(0.3, 1, 0.2, 0.5);
  const Eigen::VectorXd equal = Eigen::Vector4d(4, 3, 3, 1);
  const std::vector<double> parts = LeftOut(equal, shape, 1.1).parts();
  const std::vector<double> expected = parts_by_eigenvectors(equal, shape, 1.1);
  EXPECT_NEAR(parts[0], expected[0], 1e-9);
  EXPECT_NEAR(parts[1] + parts[2], expected[1] + expected[2], 1e-9);
  EXPECT_NEAR(parts[3], expected[3], 1e-9);
  expect_same_parts(Eigen::Vector4d(4, 3 + 1e-6, 3, 1), shape, 1.1);
}

}  // namespace
}  // namespace isomatch
