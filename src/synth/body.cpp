// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace isomatch::synth {
namespace {

Sample left_sample(const Limb& limb, const Point& p) {
  Sample result = limb.tubes.front().sample(p);
  for (std::size_t i = 1; i < limb.tubes.size(); ++i)
    result = smooth_min(result, limb.tubes[i].sample(p), limb.blend);
  return result;
}

Sample right_sample(const Limb& limb, const Point& p) {
  const Sample sample = left_sample(limb, mirrored(p));
  return {sample.value, mirrored(sample.gradient)};
}

/// The limb, both sides of it if it is paired; nothing if it is too far away to lower `value`.
std::optional<Sample> limb_sample(const Limb& limb, const Point& p, double value) {
  // A side beyond this reach changes neither the other side's sample nor, even where both sides
  // blend into one, the result.
  const double reach = value + 2.2 * limb.blend;
  const bool left = limb.bounds.distance(p) < reach;
  const bool right = limb.paired && limb.bounds.distance(mirrored(p)) < reach;
  // The two sides are joined first: smooth_min is symmetric, but not associative.
  if (left && right) return smooth_min(left_sample(limb, p), right_sample(limb, p), limb.blend);
  if (left) return left_sample(limb, p);
  if (right) return right_sample(limb, p);
  return {};
}

}  // namespace

Sample smooth_min(const Sample& a, const Sample& b, double blend) {
  const double difference = std::abs(a.value - b.value);
  const Sample& low = a.value < b.value ? a : b;
  if (difference >= blend) return low;
  const Sample& high = a.value < b.value ? b : a;
  const double h = 1 - difference / blend;
  const double share = h * h / 2;
  return {low.value - h * h * h * blend / 6, (1 - share) * low.gradient + share * high.gradient};
}

std::pair<double, double> Tube::radius(double axial) const {
  const double step = length / (kKeys - 1);
  const double x = std::clamp(axial / step, 0.0, kKeys - 1.0);
  const int i = std::min(static_cast<int>(x), kKeys - 2);
  const double t = x - i;
  const auto slope = [&](int key) {
    return key == 0 || key == kKeys - 1 ? 0 : (radii[key + 1] - radii[key - 1]) / 2;
  };
  const double rise = radii[i + 1] - radii[i], m0 = slope(i), m1 = slope(i + 1);
  const double c2 = 3 * rise - 2 * m0 - m1, c3 = m0 + m1 - 2 * rise;
  return {radii[i] + t * (m0 + t * (c2 + t * c3)), (m0 + t * (2 * c2 + t * 3 * c3)) / step};
}

Sample Tube::sample(const Point& p) const {
  const double along = axial(p), clamped = std::clamp(along, 0.0, length);
  const auto [r, slope] = radius(clamped);
  Vector offset = p - at(clamped);
  // Squeezing along x is the same for a tube and its mirror image.
  offset.x() /= width;
  const double distance = std::max(offset.norm(), 1e-12);
  offset.x() /= width;
  Vector gradient = offset / distance;
  if (along == clamped) gradient += (-gradient.dot(direction) - slope) * direction;
  return {distance - r, gradient};
}

Ball bounding_ball(const std::vector<Tube>& tubes) {
  Eigen::AlignedBox3d box;
  for (const Tube& tube : tubes) box.extend(tube.origin).extend(tube.at(tube.length));
  Ball ball{box.center(), 0};
  for (const Tube& tube : tubes) {
    // Between two radii the curve through them may rise above both, by less than a tenth.
    const double widest = 1.1 * *std::max_element(tube.radii.begin(), tube.radii.end());
    for (const Point& end : {tube.origin, tube.at(tube.length)})
      ball.radius = std::max(ball.radius, (end - ball.centre).norm() + widest);
  }
  return ball;
}

double Limb::distance(const Point& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Tube& tube : tubes) least = std::min(least, tube.sample(p).value);
  return least;
}

Sample Body::sample(const Point& p) const {
  Sample result = trunk.sample(p);
  for (const Limb& limb : limbs) {
    if (const auto sample = limb_sample(limb, p, result.value))
      result = smooth_min(result, *sample, limb.blend);
  }
  return result;
}

Point Body::project(Point p) const {
  for (int step = 0; step < 4; ++step) {
    const Sample s = sample(p);
    p -= s.value / s.gradient.squaredNorm() * s.gradient;
    if (std::abs(s.value) < 1e-5) break;
  }
  return p;
}

}  // namespace isomatch::synth
