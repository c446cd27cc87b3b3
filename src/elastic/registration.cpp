// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/registration.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isomatch::elastic {
namespace {

class Registrar {
 public:
  Registrar(const PointCloud& cloud, Deformation& deformation, const Projection& surface,
            std::span<const Point> anchors, const RegistrationOptions& options,
            std::span<const Pin> pins)
      : cloud_(cloud),
        deformation_(deformation),
        surface_(surface),
        options_(options),
        pins_(pins),
        goals_(anchors.size()),
        feet_(anchors.size()) {
    for (std::size_t i = 0; i < anchors.size(); ++i) goals_[i].anchor = anchors[i];
    deformation.set_positions({anchors.begin(), anchors.end()});
  }

  void run() {
    for (int i = 0; i < options_.initial_rotations; ++i)
      deformation_.fit_rotations(options_.rotation_smoothness);
    const int steps = options_.anchor_steps + options_.surface_steps;
    for (int step = 0; step < steps; ++step) {
      const double progress = static_cast<double>(step) / std::max(1, steps - 1);
      const double length =
          options_.first_length * std::pow(options_.last_length / options_.first_length, progress);
      for (int k = 0; k < options_.iterations; ++k)
        advance(step >= options_.anchor_steps, length * length);
    }
  }

  Registration result() {
    project();
    Registration result;
    const std::vector<double> energies = deformation_.energies();
    result.energy = std::accumulate(energies.begin(), energies.end(), 0.0);
    for (int i = 0; i < deformation_.size(); ++i) {
      result.distance += cloud_.areas[i] * (deformation_.positions()[i] - feet_[i].position).norm();
      result.deviation += cloud_.areas[i] * (1 - feet_[i].normal.dot(normal(i)));
    }
    result.feet = std::move(feet_);
    return result;
  }

 private:
  Point normal(int i) const { return deformation_.rotations()[i] * cloud_.normals[i]; }

  void project() {
    for (int i = 0; i < deformation_.size(); ++i)
      feet_[i] = surface_(deformation_.positions()[i], normal(i), cloud_.features[i]);
  }

  void advance(bool to_surface, double stiffness) {
    if (to_surface) {
      project();
      aim_at_feet();
    } else {
      for (int i = 0; i < deformation_.size(); ++i) goals_[i].anchor_weight = cloud_.areas[i];
    }
    hold_pins();
    deformation_.fit_positions(goals_, stiffness);
    deformation_.fit_rotations(options_.rotation_smoothness);
  }

  void aim_at_feet() {
    for (int i = 0; i < deformation_.size(); ++i) {
      const bool compatible = feet_[i].normal.dot(normal(i)) >= options_.min_cosine;
      Goal& goal = goals_[i];
      goal.foot = feet_[i].position;
      goal.normal = feet_[i].normal;
      goal.weight = cloud_.areas[i] * (compatible ? 1 : options_.incompatible_weight);
      goal.anchor = goal.foot;
      goal.anchor_weight = options_.friction * goal.weight;
    }
  }

  void hold_pins() {
    constexpr double kFirm = 100;  // What all others together pull against a pin moves it little.
    for (const Pin& pin : pins_) {
      goals_[pin.point].anchor = pin.position;
      goals_[pin.point].anchor_weight = kFirm * cloud_.areas[pin.point];
    }
  }

  const PointCloud& cloud_;
  Deformation& deformation_;
  const Projection& surface_;
  const RegistrationOptions& options_;
  std::span<const Pin> pins_;
  std::vector<Goal> goals_;
  std::vector<Foot> feet_;
};

}  // namespace

Registration register_onto(const PointCloud& cloud, Deformation& deformation,
                           const Projection& surface, std::span<const Point> anchors,
                           const RegistrationOptions& options, std::span<const Pin> pins) {
  Registrar registrar(cloud, deformation, surface, anchors, options, pins);
  registrar.run();
  return registrar.result();
}

}  // namespace isomatch::elastic
