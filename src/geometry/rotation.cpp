// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/rotation.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <numeric>

#include "isomatch/error.h"

namespace isomatch {

Point mean_of(std::span<const Point> points) {
  return std::accumulate(points.begin(), points.end(), Point(0, 0, 0)) /
         static_cast<double>(points.size());
}

Eigen::Matrix3d best_rotation(const Eigen::Matrix3d& covariance) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  // A plane determines a rotation, a single line does not.
  if (!(svd.singularValues()[1] > 1e-9 * svd.singularValues()[0]))
    return Eigen::Matrix3d::Identity();
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Point(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

Eigen::Matrix3d best_rotation(std::span<const Point> from, std::span<const Point> to) {
  if (from.size() != to.size()) throw InvalidInput("a rotation needs as many points on both sides");
  Point from_mean = Point::Zero(), to_mean = Point::Zero();
  for (const Point& p : from) from_mean += p / static_cast<double>(from.size());
  for (const Point& p : to) to_mean += p / static_cast<double>(to.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i)
    covariance += (to[i] - to_mean) * (from[i] - from_mean).transpose();
  return best_rotation(covariance);
}

}  // namespace isomatch
