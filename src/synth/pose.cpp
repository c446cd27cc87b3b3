// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/pose.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isomatch::synth {
namespace {

/// Rises smoothly from 0 to 1 over [0, 1]; its slope is the curvature along a joint.
double ramp(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

/// Integrals of cos(angle ramp) and sin(angle ramp) from 0 to `end`: Gauss-Legendre, 4 points.
std::pair<double, double> integrate_turn(double angle, double end) {
  constexpr double kNodes[] = {.0694318442029737, .3300094782075719, .6699905217924281,
                               .9305681557970263};
  constexpr double kWeights[] = {.1739274225687269, .3260725774312731, .3260725774312731,
                                 .1739274225687269};
  double cosine = 0, sine = 0;
  for (int i = 0; i < 4; ++i) {
    const double turn = angle * ramp(kNodes[i] * end);
    cosine += kWeights[i] * end * std::cos(turn);
    sine += kWeights[i] * end * std::sin(turn);
  }
  return {cosine, sine};
}

/// Where `p` lies along `joint`: 0 at its begin, 1 at its end.
double place_along(const Joint& joint, const Point& p) {
  return std::clamp(joint.direction.dot(p - joint.centre) / joint.length + 0.5, 0.0, 1.0);
}

Bend draw_bend(const Joint& joint, double share, Random& random) {
  Vector rotation;
  for (int i = 0; i < 3; ++i) rotation[i] = share * random.uniform(joint.low[i], joint.high[i]);
  return {joint, rotation};
}

std::vector<Bend> draw_bends(const std::vector<Joint>& joints, double share, Random& random) {
  std::vector<Bend> bends;
  bends.reserve(joints.size());
  for (const Joint& joint : joints) bends.push_back(draw_bend(joint, share, random));
  return bends;
}

}  // namespace

Bend::Bend(const Joint& joint, const Vector& rotation)
    : angle_(rotation.norm()),
      start_(joint.centre - joint.length / 2 * joint.direction),
      straight_(joint.length * joint.direction) {
  if (angle_ > 0) axis_ = rotation / angle_;
  parallel_ = axis_.dot(straight_) * axis_;
  across_ = straight_ - parallel_;
  ahead_ = axis_.cross(straight_);
}

Point Bend::move(double place, const Point& p) const {
  if (place <= 0 || angle_ == 0) return p;
  const double end = std::min(place, 1.0);
  const auto [cosine, sine] = integrate_turn(angle_, end);
  const Point centre = start_ + end * parallel_ + cosine * across_ + sine * ahead_;
  const Eigen::AngleAxisd turn(angle_ * ramp(end), axis_);
  return centre + turn * (p - (start_ + end * straight_));
}

Pose::Pose(const Body& body) : body_(&body) {}

Pose::Pose(const Body& body, double share, Random& random)
    : body_(&body), spine_(draw_bends(body.spine, share, random)) {
  for (const Limb& limb : body.limbs) {
    for (int side = 0; side < (limb.paired ? 2 : 1); ++side) {
      const Bend root = draw_bend(limb.root, share, random);
      limbs_.push_back({&limb, side == 1, root, draw_bends(limb.joints, share, random)});
    }
  }
}

Pose::Nearest Pose::nearest_limb(const Point& p) const {
  Nearest nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const LimbBends& bends : limbs_) {
    const Point left = bends.right ? mirrored(p) : p;
    if (bends.limb->bounds.distance(left) >= least) continue;
    const double distance = bends.limb->distance(left);
    if (distance >= least) continue;
    least = distance;
    nearest.limb = &bends;
  }
  if (nearest.limb) {
    const Limb& limb = *nearest.limb->limb;
    const double emergence = body_->trunk.sample(p).value - least;
    nearest.place = std::clamp((emergence - limb.root_begin) / limb.root.length, 0.0, 1.0);
  }
  return nearest;
}

Point Pose::move_limb(const Nearest& nearest, const Point& rest) {
  const auto& [limb, right, root, joints] = *nearest.limb;
  const Point left = right ? mirrored(rest) : rest;
  Point p = left;
  for (std::size_t i = joints.size(); i-- > 0;)
    p = joints[i].move(nearest.place * place_along(limb->joints[i], left), p);
  p = root.move(nearest.place, p);
  return right ? mirrored(p) : p;
}

Point Pose::operator()(const Point& rest) const {
  if (limbs_.empty()) return rest;
  const Nearest nearest = nearest_limb(rest);
  Point p = rest, anchor = rest;
  if (nearest.place > 0) {
    p = move_limb(nearest, rest);
    // A limb follows the spine as the place does where it joins the trunk.
    anchor += ramp(nearest.place) * (nearest.limb->limb->root.centre - rest);
  }
  for (std::size_t i = spine_.size(); i-- > 0;)
    p = spine_[i].move(place_along(body_->spine[i], anchor), p);
  return p;
}

}  // namespace isomatch::synth
