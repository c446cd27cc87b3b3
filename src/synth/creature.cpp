// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/creature.h"

namespace isomatch::synth {
namespace {

Joint joint_along(const Tube& tube, double share, double length, const Vector& low,
                  const Vector& high) {
  return {tube.at(share * tube.length), tube.direction, length, low, high};
}

/// Lets `limb` turn about the place where its axis leaves the trunk.
void add_root(Limb& limb, double axial, double length, const Vector& low, const Vector& high) {
  const Tube& tube = limb.tubes.front();
  limb.root = {tube.at(axial), tube.direction, length, low, high};
}

Tube make_trunk(Random& random) {
  const double girth = random.uniform(0.85, 1.05);
  Tube trunk{{0, 0, -0.04}, Vector::UnitZ(), 1.06, {}, 0.85};
  trunk.radii = {0.17, 0.185, 0.19, 0.22, 0.18};
  for (double& radius : trunk.radii) radius *= girth * random.uniform(0.95, 1.05);
  return trunk;
}

Limb make_leg(Random& random, double z, double length, double thickness) {
  Tube leg{{0.135, -0.04, z}, Vector(0.06, -1, 0).normalized(), length, {}};
  leg.radii = {0.11, 0.088, 0.062, 0.056, 0.045};
  for (double& radius : leg.radii) radius *= thickness * random.uniform(0.95, 1.05);
  Tube foot{leg.at(length), Vector(0, -0.05, 1).normalized(), random.uniform(0.08, 0.13), {}};
  foot.radii = {0.048, 0.052, 0.055, 0.05, 0.042};
  Limb limb{{leg, foot}, 0.08, true, {}, 0, {}};
  return limb;
}

void add_leg_joints(Limb& limb, double knee_sign) {
  const Tube& leg = limb.tubes.front();
  add_root(limb, 0.25, 0.22, Vector(-0.5, 0, 0), Vector(0.5, 0, 0.25));
  const Vector bent = Vector(knee_sign * 0.9, 0, 0);
  limb.joints.push_back(joint_along(leg, 0.56, 0.2, bent.cwiseMin(0), bent.cwiseMax(0)));
  limb.joints.push_back(joint_along(leg, 0.82, 0.14, Vector(-0.5, 0, 0), Vector(0.5, 0, 0)));
}

Limb make_legs(Random& random, double z, double length, double thickness, double knee_sign) {
  Limb limb = make_leg(random, z, length, thickness);
  add_leg_joints(limb, knee_sign);
  return limb;
}

Limb make_head(Random& random) {
  const double rise = random.uniform(0.6, 1.1);
  Tube neck{{0, 0.05, 0.98},
            Vector(0, std::sin(rise), std::cos(rise)),
            random.uniform(0.45, 0.7),
            {0.15, 0.125, 0.1, 0.09, 0.088}};
  Tube skull{neck.at(neck.length),
             Vector(0, random.uniform(-0.5, -0.2), 1).normalized(),
             random.uniform(0.22, 0.32),
             {0.11, 0.108, 0.085, 0.068, 0.056}};
  Limb limb{{neck, skull}, 0.08, false, {}, 0, {}};
  for (double side : {-1.0, 1.0}) {
    Tube ear{skull.origin + Vector(side * 0.065, 0.07, -0.03),
             Vector(side * 0.5, 1, -0.25).normalized(),
             0.12,
             {0.04, 0.042, 0.042, 0.036, 0.028}};
    limb.tubes.push_back(ear);
  }
  add_root(limb, 0.22, 0.22, Vector(-0.4, -0.3, 0), Vector(0.3, 0.3, 0));
  limb.joints.push_back(
      joint_along(limb.tubes[0], 0.75, 0.2, Vector(-0.5, -0.5, 0), Vector(0.5, 0.5, 0)));
  return limb;
}

Limb make_tail(Random& random) {
  Tube tail{{0, 0.06, -0.08},
            Vector(0, random.uniform(-0.5, 0.4), -1).normalized(),
            random.uniform(0.6, 1.0),
            {0.075, 0.055, 0.045, 0.04, 0.032}};
  Limb limb{{tail}, 0.08, false, {}, 0, {}};
  add_root(limb, 0.2, 0.2, Vector(-0.4, -0.4, 0), Vector(0.4, 0.4, 0));
  for (double share : {0.5, 0.75})
    limb.joints.push_back(
        joint_along(tail, share, 0.2, Vector(-0.7, -0.7, 0), Vector(0.7, 0.7, 0)));
  return limb;
}

}  // namespace

Body make_creature(Random& random) {
  Body body;
  body.trunk = make_trunk(random);
  for (double share : {0.35, 0.68})
    body.spine.push_back(
        joint_along(body.trunk, share, 0.4, Vector(-0.12, -0.2, 0), Vector(0.12, 0.2, 0)));
  const double front = random.uniform(0.62, 0.75);
  const double hind = front * random.uniform(0.75, 0.9);
  body.limbs.push_back(make_head(random));
  body.limbs.push_back(make_tail(random));
  body.limbs.push_back(make_legs(random, 0.9, front, random.uniform(0.85, 1), 1));
  body.limbs.push_back(make_legs(random, 0.06, hind, random.uniform(1, 1.15), -1));
  return body;
}

}  // namespace isomatch::synth
