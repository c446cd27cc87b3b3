// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "group/left_out.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace isomatch {
LeftOut::LeftOut(const Eigen::VectorXd& squares, const Eigen::VectorXd& shape, double factor)
    : factor_(factor), rounding_(1e-13 * squares[0]) {
  const Eigen::VectorXd weights = factor * shape.cwiseAbs2();
  std::vector<Eigen::Index> changed;
  for (Eigen::Index k = 0; k < squares.size(); ++k)
    if (weights[k] > rounding_)
      changed.push_back(k);
    else
      unchanged_.push_back({squares[k], 0});
  squares_ = squares(changed);
  weights_ = weights(changed);
}

std::vector<double> LeftOut::parts() const {
  std::vector<Axis> axes = unchanged_;
  for (Eigen::Index k = 0; k < squares_.size(); ++k) axes.push_back(axis_below(k));
  std::ranges::stable_sort(axes, std::greater(), &Axis::square);
  std::vector<double> parts;
  for (const Axis& axis : axes) parts.push_back(axis.part);
  return parts;
}

LeftOut::Axis LeftOut::axis_below(Eigen::Index k) const {
  const bool is_last = k + 1 == squares_.size();
  const double high = squares_[k], low = is_last ? 0 : squares_[k + 1];
  if (high - low <= rounding_) return {low, 0};
  // The others may not vary along the last one.
  constexpr double kNoVariance = 1e-9;
  if (is_last && secular(0, 0) <= kNoVariance) return {0, 0};
  const double half = (high - low) / 2;
  const bool is_near_high = secular(high, -half) > 0;
  const Interval interval = is_near_high ? Interval{k, high, -half, 0} : Interval{k, low, 0, half};
  const double offset = zero(interval);
  const double sum = (weights_ / ((squares_.array() - interval.end) - offset).square()).sum();
  return {interval.end + offset, sum > 0 && std::isfinite(sum) ? 1 / (factor_ * sum) : 0};
}

/// Falls from each of `squares` to the next above it.
double LeftOut::secular(double end, double offset) const {
  return 1 - (weights_ / ((squares_.array() - end) - offset)).sum();
}

double LeftOut::zero(Interval interval) const {
  // Some six do; where rounding is in the way, halvings, until the bits of a number are used up.
  constexpr int kMostSteps = 60;
  constexpr double kExact = 1e-9;
  double offset = (interval.low + interval.high) / 2;
  for (int step = 0; step < kMostSteps; ++step) {
    double next = next_guess(interval, offset);
    if (!(next > interval.low && next < interval.high)) next = (interval.low + interval.high) / 2;
    const double change = std::abs(next - offset);
    offset = next;
    if (change <= kExact * std::abs(next)) break;
  }
  return offset;
}

/// The zero of the rational function that has a pole at each end, and of which either half has
/// value and slope as here (Bunch, Nielsen and Sorensen 1978).
double LeftOut::next_guess(Interval& interval, double offset) const {
  const Eigen::Index above = interval.k + 1, below = squares_.size() - above;
  const Eigen::ArrayXd distances = (squares_.array() - interval.end) - offset;
  const Eigen::ArrayXd terms = weights_ / distances;
  const Eigen::ArrayXd slopes = terms / distances;
  const double to_high = distances[above - 1];
  const double high_slope = slopes.head(above).sum();
  const double high_weight = high_slope * to_high * to_high;
  const double high_sum = terms.head(above).sum(), low_sum = terms.tail(below).sum();
  (1 - high_sum - low_sum > 0 ? interval.low : interval.high) = offset;
  double rest = 1 - high_sum + high_slope * to_high;
  const double high = squares_[above - 1] - interval.end;
  if (below == 0) return high - high_weight / rest;
  const double to_low = distances[above];
  const double low_slope = slopes.tail(below).sum();
  const double low_weight = low_slope * to_low * to_low;
  rest += low_slope * to_low - low_sum;
  const double low = squares_[above] - interval.end;
  // rest (high - x) (low - x) = high_weight (low - x) + low_weight (high - x)
  const double linear = rest * (high + low) - high_weight - low_weight;
  const double constant = rest * high * low - high_weight * low - low_weight * high;
  const double root = std::sqrt(std::max(0.0, linear * linear - 4 * rest * constant));
  const double sum = (linear + std::copysign(root, linear)) / 2;
  const double first = sum / rest, second = constant / sum;
  return first > interval.low && first < interval.high ? first : second;
}

}  // namespace isomatch
