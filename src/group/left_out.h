// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

namespace isomatch {

/// A shape s that is left out of those, which vary, whose sums of squares along the principal axes
/// are `squares`, largest first. The sums of products of the others are these minus `factor` s s^T,
/// whose eigenvalues are the zeros of a secular equation (Golub 1973), one below each of `squares`:
/// faster than a problem of eigenvalues for each shape.
class LeftOut {
 public:
  LeftOut(const Eigen::VectorXd& squares, const Eigen::VectorXd& shape, double factor);

  /// The squares of the parts of s that lie along the principal axes of the others, largest first.
  /// O(K^2).
  std::vector<double> parts() const;

 private:
  /// Between consecutive `squares`, or below the last: offsets from the end that is closer to the
  /// zero, so that small distances from it are exact.
  struct Interval {
    Eigen::Index k;
    double end, low, high;
  };

  struct Axis {
    double square, part;
  };

  /// The one below `squares_[k]`.
  Axis axis_below(Eigen::Index k) const;
  double secular(double end, double offset) const;
  double zero(Interval interval) const;
  /// Narrows the interval by the sign at `offset`, and returns where the zero seems to be.
  double next_guess(Interval& interval, double offset) const;

  /// Of the axes along which s has a part.
  Eigen::VectorXd squares_;
  Eigen::ArrayXd weights_;
  /// The axes that are the same for the others, and have nothing of s.
  std::vector<Axis> unchanged_;
  double factor_;
  /// What is taken for rounding.
  double rounding_;
};

}  // namespace isomatch
