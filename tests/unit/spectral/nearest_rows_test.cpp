// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/nearest_rows.h"

#include <gtest/gtest.h>

#include "support/context.h"

namespace isomatch::spectral {
namespace {

TEST(NearestRows, AreThoseOfBruteForce) {
  const Eigen::MatrixXf queries = Eigen::MatrixXf::Random(150, 7);
  const Eigen::MatrixXf points = Eigen::MatrixXf::Random(80, 7);
  const std::vector<int> nearest = nearest_rows(queries, points, test::with_threads(2));
  for (int i = 0; i < queries.rows(); ++i) {
    Eigen::Index expected = 0;
    (points.rowwise() - queries.row(i)).rowwise().squaredNorm().minCoeff(&expected);
    EXPECT_EQ(nearest[i], expected);
  }
}

/// With so many columns only the first decide what is looked at.
TEST(NearestRows, OfManyColumnsAreThoseOfBruteForce) {
  const Eigen::MatrixXf queries = Eigen::MatrixXf::Random(150, 90);
  Eigen::MatrixXf points = Eigen::MatrixXf::Random(200, 90);
  points.topRows(150) = queries + 0.3F * Eigen::MatrixXf::Random(150, 90);
  points.bottomRows(10) = points.topRows(10);  // Equally near, and later.
  const std::vector<int> nearest = nearest_rows(queries, points, test::with_threads(2));
  for (int i = 0; i < queries.rows(); ++i) {
    Eigen::Index expected = 0;
    (points.rowwise() - queries.row(i)).rowwise().squaredNorm().minCoeff(&expected);
    EXPECT_EQ(nearest[i], expected);
  }
}

}  // namespace
}  // namespace isomatch::spectral
