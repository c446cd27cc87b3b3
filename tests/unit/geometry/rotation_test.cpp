// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/rotation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "isomatch/error.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"

namespace isomatch {
namespace {

TEST(BestRotation, FindsTheRotationOfARotatedCopy) {
  const Mesh mesh = test::rough_sphere(2, 0.3, 5);
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(2.1, Point(1, -2, 0.5).normalized()).toRotationMatrix();
  std::vector<Point> to;
  for (const Point& p : mesh.vertices) to.emplace_back(3 * (rotation * p) + Point(7, 8, 9));
  EXPECT_LT((best_rotation(mesh.vertices, to) - rotation).norm(), 1e-9);
}

TEST(BestRotation, AMirrorImageStillGetsARotation) {
  const Mesh mesh = test::rough_sphere(2, 0.3, 5);
  const Eigen::Matrix3d rotation = best_rotation(mesh.vertices, test::mirrored(mesh).vertices);
  EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-9);
  EXPECT_NEAR(rotation.determinant(), 1, 1e-9);
}

TEST(BestRotation, PointsThatDetermineNoneGiveTheIdentity) {
  const std::vector<Point> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, one{{1, 2, 3}};
  EXPECT_EQ(best_rotation(line, line), Eigen::Matrix3d::Identity());
  EXPECT_EQ(best_rotation(one, one), Eigen::Matrix3d::Identity());
  EXPECT_THROW(best_rotation(one, line), InvalidInput);
}

TEST(BestRotation, OfACovarianceTurnsTheVectors) {
  test::Random random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Matrix3d rotation = random.rotation();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    // Three vectors span space; a plane would do.
    for (int i = 0; i < 3; ++i) {
      const Point a = random.direction();
      covariance += rotation * a * a.transpose();
    }
    EXPECT_LT((best_rotation(covariance) - rotation).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace isomatch
