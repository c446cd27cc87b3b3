// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::synth {

using Vector = Eigen::Vector3d;

/// Negates x: the mirror image under the left-right symmetry.
inline Vector mirrored(const Vector& p) { return {-p.x(), p.y(), p.z()}; }

/// A function's value and gradient at a point.
struct Sample {
  double value;
  Vector gradient;
};

/// The lower of two samples, smoothed (twice differentiable) where they differ by less than
/// `blend`.
Sample smooth_min(const Sample& a, const Sample& b, double blend);

/// A straight round limb of smoothly varying thickness with rounded ends.
struct Tube {
  static constexpr int kKeys = 5;

  Point origin;
  /// Unit vector along the axis.
  Vector direction;
  double length;
  /// Radius at evenly spaced places from the origin to the far end.
  std::array<double, kKeys> radii;
  /// Width from side to side relative to the height, at most 1.
  double width = 1;

  /// Coordinate along the axis: 0 at the origin, `length` at the far end.
  double axial(const Point& p) const { return direction.dot(p - origin); }
  Point at(double axial) const { return origin + axial * direction; }
  /// Value and derivative of the radius, constant beyond the ends.
  std::pair<double, double> radius(double axial) const;
  /// Roughly the signed distance to the surface, negative inside; zero exactly on the surface.
  /// Never below the distance to a ball around the tube.
  Sample sample(const Point& p) const;
};

struct Ball {
  Point centre = Point::Zero();
  double radius = 0;

  double distance(const Point& p) const { return (p - centre).norm() - radius; }
};

/// A ball around `tubes`.
Ball bounding_ball(const std::vector<Tube>& tubes);

/// A place where a body bends: an interval of a straight axis.
struct Joint {
  /// Middle of the interval and unit direction of the axis.
  Point centre;
  Vector direction;
  double length;
  /// Componentwise range of the rotation vector that poses draw from, in radians.
  Vector low, high;
};

/// One or more tubes that hang together and move by joints of their own. `tubes[0]` meets the
/// trunk.
struct Limb {
  std::vector<Tube> tubes = {};
  /// Width of the smooth transition to the trunk and between the tubes.
  double blend = 0;
  /// True for a limb on the left (x > 0) that has a mirror image on the right.
  bool paired = false;
  /// How the limb turns as a whole. Its interval follows the skin out of the trunk, from
  /// `root_begin` to `root_begin + root.length` in units of `Body::depth`.
  Joint root = {};
  double root_begin = 0;
  /// Joints along `tubes[0]`, from the trunk outwards.
  std::vector<Joint> joints = {};
  /// Around the tubes: lets a search pass over limbs that are far away.
  Ball bounds = {};

  /// Smallest value of the tubes' samples, for the limb as given (left).
  double distance(const Point& p) const;
};

/// A body with left-right symmetry as a smooth implicit surface: a trunk along z and limbs.
struct Body {
  Tube trunk;
  /// Joints along the trunk, from back to front.
  std::vector<Joint> spine;
  std::vector<Limb> limbs;

  /// The implicit function: negative inside, zero on the skin, and equal at mirrored points.
  Sample sample(const Point& p) const;
  /// The point of the skin near `p` that steepest descent leads to.
  Point project(Point p) const;
  /// Outward unit normal of the skin near `p`.
  Vector normal(const Point& p) const { return sample(p).gradient.normalized(); }
};

}  // namespace isomatch::synth
