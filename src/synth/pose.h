// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <vector>

#include "random.h"
#include "synth/body.h"

namespace isomatch::synth {

/// A joint bent by a rotation vector. The axis follows a smooth curve of unchanged length, and what
/// surrounds it is carried along rigidly, slice by slice, so that a tube keeps its thickness.
class Bend {
 public:
  Bend(const Joint& joint, const Vector& rotation);

  /// Moves `p` as the slice at `place` moves: 0 and below is before the joint and stays, 1 and
  /// above is past it.
  Point move(double place, const Point& p) const;

 private:
  Vector axis_ = Vector::UnitZ();
  double angle_ = 0;
  Point start_;
  Vector straight_;
  /// What the rotation leaves of `straight_`, turns, and turns it towards.
  Vector parallel_, across_, ahead_;
};

/// The deformation that takes a body from rest to a pose.
class Pose {
 public:
  /// The body at rest.
  explicit Pose(const Body& body);
  /// Draws a rotation for every joint within `share` of its range. Keeps a reference to `body`.
  Pose(const Body& body, double share, Random& random);

  /// Where a point on or near the skin goes.
  Point operator()(const Point& rest) const;

 private:
  struct LimbBends {
    const Limb* limb;
    bool right;
    Bend root;
    std::vector<Bend> joints;
  };

  /// The limb nearest to `p`, and how far along its root joint `p` is: 0 on the trunk, 1 past it.
  struct Nearest {
    const LimbBends* limb = nullptr;
    double place = 0;
  };

  Nearest nearest_limb(const Point& p) const;
  static Point move_limb(const Nearest& nearest, const Point& rest);

  const Body* body_;
  std::vector<Bend> spine_;
  std::vector<LimbBends> limbs_;
};

}  // namespace isomatch::synth
