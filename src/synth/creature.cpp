// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/creature.h"

#include <algorithm>
#include <cmath>

namespace isomatch::synth {
namespace {

/// Width of the smooth transitions between limbs and trunk.
constexpr double kBlend = 0.08;

/// A unit vector in the plane of symmetry, `angle` radians above z.
Vector in_profile(double angle) { return {0, std::sin(angle), std::cos(angle)}; }

using Radii = std::array<double, Tube::kKeys>;

Radii scaled(double scale, Radii radii) {
  for (double& radius : radii) radius *= scale;
  return radii;
}

/// Scales the radii as a whole and then each a little, which makes a short tube bumpy.
Radii varied(Random& random, double scale, Radii radii) {
  for (double& radius : radii) radius *= scale * random.uniform(0.94, 1.06);
  return radii;
}

/// A joint of the given length whose middle is at `axial`, with its range reduced where needed to
/// keep the inner side of the bent tube from folding.
Joint joint_at(const Tube& tube, double axial, double length, const Vector& low,
               const Vector& high) {
  const double limit = 0.45 * length / tube.radius(axial).first;
  const double share = std::min(1.0, limit / std::max(low.norm(), high.norm()));
  return {tube.at(axial), tube.direction, length, share * low, share * high};
}

Joint joint_at(const Tube& tube, double axial, double length, const Vector& reach) {
  return joint_at(tube, axial, length, -reach, reach);
}

Tube make_trunk(Random& random) {
  Tube trunk{{0, 0, -0.04}, Vector::UnitZ(), 1.06, {}, random.uniform(0.78, 0.92)};
  trunk.radii = varied(random, random.uniform(0.85, 1.25), {0.165, 0.185, 0.185, 0.215, 0.175});
  return trunk;
}

/// A pair of legs at `z` that reach `length` below the trunk. Their knees bend towards `knee` along
/// z.
Limb make_legs(Random& random, const Tube& trunk, double z, double length, double thickness,
               double knee) {
  const double girth = trunk.radius(trunk.axial({0, 0, z})).first;
  // Any closer together, the thighs would fuse.
  const double x = std::max(0.12 * thickness + 0.02, 0.75 * trunk.width * girth);
  Tube leg{{x, -0.04, z}, Vector(random.uniform(0, 0.1), -1, 0).normalized(), length + girth, {}};
  leg.radii = varied(random, thickness, {0.115, 0.092, 0.062, 0.057, 0.05});
  Tube foot{leg.at(leg.length), in_profile(-0.05), random.uniform(0.06, 0.13), {}};
  foot.radii = scaled(thickness, {0.048, 0.053, 0.055, 0.053, 0.05});

  Limb limb{{leg, foot}, kBlend, true};
  limb.root = joint_at(leg, girth + 0.05, 0.26, {-0.6, -0.1, -0.05}, {0.6, 0.1, 0.25});
  const Vector knee_bent(knee * 1.3, 0, 0);
  limb.joints = {joint_at(leg, girth + 0.44 * length, 0.4 * length, knee_bent.cwiseMin(0),
                          knee_bent.cwiseMax(0)),
                 joint_at(leg, girth + 0.75 * length, 0.24 * length, {0.6, 0, 0})};
  return limb;
}

Tube make_ear(const Tube& skull, double length, double tilt, double side) {
  const Vector direction = Vector(side * tilt, 1, -0.3).normalized();
  Tube ear{skull.at(0.02) + Vector(side * 0.06, 0.06, 0), direction, length, {}};
  ear.radii = {0.048, 0.05, 0.05, 0.048, 0.043};
  return ear;
}

Limb make_head(Random& random) {
  const double rise = random.uniform(0.35, 1.2), girth = random.uniform(0.85, 1.15);
  Tube neck{{0, 0.04, 0.97}, in_profile(rise), random.uniform(0.5, 0.88), {}};
  neck.radii = varied(random, girth, {0.155, 0.13, 0.105, 0.095, 0.095});
  Tube skull{
      neck.at(neck.length), in_profile(random.uniform(-0.6, 0)), random.uniform(0.18, 0.4), {}};
  skull.radii = scaled(girth, {0.115, 0.11, 0.085, 0.068, 0.058});

  Limb limb{{neck, skull}, kBlend};
  const double ear_length = random.uniform(0.1, 0.26), tilt = random.uniform(0.3, 0.9);
  for (double side : {1.0, -1.0}) limb.tubes.push_back(make_ear(skull, ear_length, tilt, side));
  limb.root = joint_at(neck, 0.2, 0.24, {0.45, 0.45, 0});
  limb.joints = {joint_at(neck, neck.length - 0.22, 0.2, {0.6, 0.5, 0.1})};
  return limb;
}

Limb make_tail(Random& random) {
  const double droop = random.uniform(-0.4, 0.8);
  Tube tail{{0, 0.06, -0.08}, -in_profile(droop), random.uniform(0.5, 1.25), {}};
  tail.radii = varied(random, random.uniform(0.92, 1.25), {0.08, 0.064, 0.057, 0.053, 0.048});

  Limb limb{{tail}, kBlend};
  limb.root = joint_at(tail, 0.18, 0.2, {0.5, 0.5, 0});
  for (double share : {0.45, 0.65, 0.85})
    limb.joints.push_back(joint_at(tail, share * tail.length, 0.2 * tail.length, {0.7, 0.7, 0}));
  return limb;
}

}  // namespace

Body make_creature(Random& random) {
  Body body;
  body.trunk = make_trunk(random);
  for (double share : {0.35, 0.68})
    body.spine.push_back(joint_at(body.trunk, share, 0.4, {0.14, 0.18, 0}));

  const double front = random.uniform(0.38, 0.7), hind = front * random.uniform(0.7, 0.88);
  const double thickness = random.uniform(0.9, 1) * (0.75 + 0.45 * front);
  const auto legs = [&](double z, double length, double scale, double knee) {
    return make_legs(random, body.trunk, z, length, scale * thickness, knee);
  };
  body.limbs = {make_head(random), make_tail(random), legs(0.9, front, 1, 1),
                legs(0.05, hind, 1.12, -1)};
  const bool six_legs = random.below(4) == 0;
  if (six_legs) body.limbs.push_back(legs(0.48, 0.85 * hind, 0.9, 1));
  for (Limb& limb : body.limbs) limb.bounds = bounding_ball(limb.tubes);
  return body;
}

}  // namespace isomatch::synth
