// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>

namespace isomatch {

/// A shape s that is left out of those whose sums of squares along the principal axes are
/// `squares`, largest first. The sums of products of the others are these minus `factor` s s^T,
/// whose eigenvalues are the zeros of a secular equation (Golub 1973), one below each of `squares`:
/// faster than a problem of eigenvalues for each shape.
class LeftOut {
 public:
  LeftOut(const Eigen::VectorXd& squares, const Eigen::VectorXd& shape, double factor);

  /// The square of the part of s that lies along principal axis k of the others. O(K).
  double part_along(Eigen::Index k) const;

 private:
  /// Between consecutive `squares`, or below the last: offsets from the end that is closer to the
  /// zero, so that small distances from it are exact.
  struct Interval {
    Eigen::Index k;
    double end, low, high;
  };

  double secular(double end, double offset) const;
  double zero(Interval interval) const;
  /// Narrows the interval by the sign at `offset`, and returns where the zero seems to be.
  double next_guess(Interval& interval, double offset) const;

  const Eigen::VectorXd& squares_;
  Eigen::ArrayXd weights_;
  double factor_;
};

}  // namespace isomatch
