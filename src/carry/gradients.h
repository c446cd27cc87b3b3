// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::transfer {

/// How faces of a mesh deform from rest to another pose: linear maps of space that take edges to
/// edges and the normal to the normal, scaled like the edges (Sumner and Popovic 2004, Section 3).
class FaceGradients {
 public:
  explicit FaceGradients(const Mesh& rest);

  /// Whether face `face` spans a plane, so that it has a gradient.
  bool has(int face) const { return inverse_[face].has_value(); }
  /// Precondition: `has(face)`.
  Eigen::Matrix3d operator()(int face, std::span<const Point> positions) const;

 private:
  std::vector<Face> faces_;
  std::vector<std::optional<Eigen::Matrix3d>> inverse_;
};

}  // namespace isomatch::transfer
