// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/collision.h"

#include <vector>

namespace isomatch::synth {
namespace {

/// Gaps between parts that count as separate at rest, and that they must keep.
constexpr double kSeparate = 0.08, kKept = 0.03;

void add_balls(const Tube& tube, bool right, std::vector<Ball>& balls) {
  constexpr int kBalls = 12;
  for (int i = 0; i < kBalls; ++i) {
    const double axial = tube.length * i / (kBalls - 1);
    const Point centre = tube.at(axial);
    balls.push_back({right ? mirrored(centre) : centre, tube.radius(axial).first});
  }
}

std::vector<Ball> balls_inside(const Body& body) {
  std::vector<Ball> balls;
  add_balls(body.trunk, false, balls);
  for (const Limb& limb : body.limbs) {
    for (const Tube& tube : limb.tubes) {
      add_balls(tube, false, balls);
      if (limb.paired) add_balls(tube, true, balls);
    }
  }
  return balls;
}

double gap(const Ball& a, const Ball& b) { return a.distance(b.centre) - b.radius; }

}  // namespace

bool collides(const Body& body, const Pose& pose) {
  const std::vector<Ball> rest = balls_inside(body);
  std::vector<Ball> posed = rest;
  for (Ball& ball : posed) ball.centre = pose(ball.centre);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      if (gap(posed[i], posed[j]) < kKept && gap(rest[i], rest[j]) > kSeparate) return true;
  }
  return false;
}

}  // namespace isomatch::synth
