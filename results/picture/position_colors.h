// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/mesh/mesh.h"
#include "results/picture/image.h"

namespace isomatch::picture {

/// Colours that vary smoothly over space, so that a map that carries them over shows where it tears
/// and whether it flips. They lie in Oklab, a space of even perceived differences: along the
/// longest direction from blue and dark to yellow and light, which everybody can tell apart, along
/// the second from green to magenta, along the third lighter.
class PositionColors {
 public:
  /// Directions are the rows of `frame`, orthonormal; ranges are those of `points`, but for the
  /// outermost hundredth at each end. Throws `InvalidInput` if there are no points. O(N).
  PositionColors(const Eigen::Matrix3d& frame, std::span<const Point> points);

  Color operator()(const Point& point) const;

  /// Rows: the longest, second and third direction; `point` lies at `(axes * point - low) / size`.
  const Eigen::Matrix3d& axes() const { return axes_; }
  const Point& low() const { return low_; }
  const Point& size() const { return size_; }

 private:
  Eigen::Matrix3d axes_;
  Point low_, size_;
};

/// The colour at lightness `l` and green-red and blue-yellow opponents `a` and `b` (Ottosson 2020).
Color from_oklab(float l, float a, float b);

/// What has no partner.
inline const Color kUnmatchedColor{0.3F, 0.3F, 0.3F};

}  // namespace isomatch::picture
