// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "carry/gradients.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace isomatch::transfer {
namespace {

/// Two edges and the normal, as long as the root of its cross product.
Eigen::Matrix3d frame(const Face& face, std::span<const Point> positions) {
  const Point u = positions[face[1]] - positions[face[0]];
  const Point w = positions[face[2]] - positions[face[0]];
  const Point normal = u.cross(w);
  const double length = normal.norm();
  Eigen::Matrix3d columns;
  columns << u, w, (length > 0 ? Point(normal / std::sqrt(length)) : Point::Zero());
  return columns;
}

/// Height over longest side below which a triangle is taken for a line.
constexpr double kFlattest = 1e-6;

bool spans_plane(const Eigen::Matrix3d& frame) {
  const Point u = frame.col(0), w = frame.col(1);
  const double longest = std::max({u.squaredNorm(), w.squaredNorm(), (u - w).squaredNorm()});
  return u.cross(w).norm() > kFlattest * longest;
}

}  // namespace

FaceGradients::FaceGradients(const Mesh& rest) : faces_(rest.faces) {
  inverse_.reserve(faces_.size());
  for (const Face& face : faces_) {
    const Eigen::Matrix3d columns = frame(face, rest.vertices);
    inverse_.push_back(spans_plane(columns) ? std::optional(columns.inverse().eval())
                                            : std::nullopt);
  }
}

Eigen::Matrix3d FaceGradients::operator()(int face, std::span<const Point> positions) const {
  return frame(faces_[face], positions) * *inverse_[face];
}

}  // namespace isomatch::transfer
