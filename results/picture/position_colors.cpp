// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/picture/position_colors.h"

#include <algorithm>
#include <array>

#include "isomatch/error.h"

namespace isomatch::picture {
namespace {

struct Range {
  double low, size;
};

/// Without the outermost hundredth at each end; never empty.
Range inner_range(const Point& direction, std::span<const Point> points) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const Point& p : points) values.push_back(direction.dot(p));
  std::ranges::sort(values);
  const std::size_t cut = values.size() / 100;
  const double low = values[cut], high = values[values.size() - 1 - cut];
  return {low, high > low ? high - low : 1};
}

}  // namespace

PositionColors::PositionColors(const Eigen::Matrix3d& frame, std::span<const Point> points) {
  if (points.empty()) throw InvalidInput("position colours need points");
  std::array<Range, 3> ranges;
  std::array<int, 3> order{0, 1, 2};
  for (int k = 0; k < 3; ++k) ranges[k] = inner_range(frame.row(k), points);
  std::ranges::stable_sort(order, std::greater{}, [&](int k) { return ranges[k].size; });
  for (int k = 0; k < 3; ++k) {
    axes_.row(k) = frame.row(order[k]);
    low_[k] = ranges[order[k]].low;
    size_[k] = ranges[order[k]].size;
  }
}

Color PositionColors::operator()(const Point& point) const {
  const Point place = ((axes_ * point - low_).array() / size_.array()).cwiseMax(0).cwiseMin(1);
  const Eigen::Vector3f t = place.cast<float>();
  return from_oklab(0.42F + 0.18F * t[0] + 0.28F * t[2], -0.15F + 0.32F * t[1],
                    -0.19F + 0.35F * t[0]);
}

Color from_oklab(float l, float a, float b) {
  const auto cube = [](float x) { return x * x * x; };
  const float long_cone = cube(l + 0.3963377774F * a + 0.2158037573F * b);
  const float medium = cube(l - 0.1055613458F * a - 0.0638541728F * b);
  const float small = cube(l - 0.0894841775F * a - 1.2914855480F * b);
  const Color linear(4.0767416621F * long_cone - 3.3077115913F * medium + 0.2309699292F * small,
                     -1.2684380046F * long_cone + 2.6097574011F * medium - 0.3413193965F * small,
                     -0.0041960863F * long_cone - 0.7034186147F * medium + 1.7076147010F * small);
  return linear.cwiseMax(0).cwiseMin(1);
}

}  // namespace isomatch::picture
