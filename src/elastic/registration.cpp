// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/registration.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "parallel.h"

namespace isomatch::elastic {
namespace {

class Registrar {
 public:
  Registrar(const PointCloud& cloud, Deformation& deformation, const Projection& surface,
            std::span<const Point> anchors, const RegistrationOptions& options,
            std::span<const Pin> pins, const Context& context)
      : cloud_(cloud),
        deformation_(deformation),
        surface_(surface),
        options_(options),
        pins_(pins),
        context_(context),
        goals_(anchors.size()),
        feet_(anchors.size()) {
    for (std::size_t i = 0; i < anchors.size(); ++i) goals_[i].anchor = anchors[i];
    deformation.set_positions({anchors.begin(), anchors.end()});
  }

  void run() {
    for (int i = 0; i < options_.initial_rotations; ++i)
      deformation_.fit_rotations(options_.rotation_smoothness, context_);
    const int steps = options_.anchor_steps + options_.surface_steps;
    for (int step = 0; step < steps; ++step) {
      const double progress = static_cast<double>(step) / std::max(1, steps - 1);
      const double length =
          options_.first_length * std::pow(options_.last_length / options_.first_length, progress);
      for (int k = 0; k < options_.iterations; ++k) advance(step >= options_.anchor_steps, length);
    }
  }

  Registration result() {
    project();
    Registration result;
    const std::vector<double> energies = deformation_.energies();
    result.energy = std::accumulate(energies.begin(), energies.end(), 0.0);
    for (int i = 0; i < deformation_.size(); ++i) {
      result.met.push_back(meets(i, std::max(options_.reach, options_.last_length)));
      if (!cloud_.is_inside(i)) continue;
      result.distance += cloud_.areas[i] * (deformation_.positions()[i] - feet_[i].position).norm();
      result.deviation += cloud_.areas[i] * (1 - feet_[i].normal.dot(normal(i)));
    }
    result.feet = std::move(feet_);
    return result;
  }

 private:
  Point normal(int i) const { return deformation_.rotations()[i] * cloud_.normals[i]; }

  void project() {
    parallel_for(deformation_.size(), context_, [&](std::ptrdiff_t k) {
      const int i = static_cast<int>(k);
      feet_[i] =
          surface_(deformation_.positions()[i], normal(i), cloud_.features[i], feet_[i].point);
    });
  }

  void advance(bool to_surface, double length) {
    if (to_surface) {
      project();
      aim_at_feet(std::max(length, options_.reach));
    } else {
      for (int i = 0; i < deformation_.size(); ++i) goals_[i].anchor_weight = cloud_.areas[i];
    }
    if (!cloud_.inside.empty()) release_outside();
    hold_pins();
    deformation_.fit_positions(goals_, length * length);
    deformation_.fit_rotations(options_.rotation_smoothness, context_);
  }

  void aim_at_feet(double reach) {
    for (int i = 0; i < deformation_.size(); ++i) {
      const bool compatible = meets(i, reach);
      Goal& goal = goals_[i];
      goal.foot = feet_[i].position;
      goal.normal = feet_[i].normal;
      goal.weight = cloud_.areas[i] * (compatible ? 1 : options_.incompatible_weight);
      goal.anchor = goal.foot;
      goal.anchor_weight = options_.friction * goal.weight;
    }
  }

  bool meets(int i, double reach) const {
    return feet_[i].normal.dot(normal(i)) >= options_.min_cosine &&
           (cloud_.inside.empty() || (!feet_[i].on_rim && distance(i) <= reach));
  }

  double distance(int i) const { return (deformation_.positions()[i] - feet_[i].position).norm(); }

  /// What has no counterpart is held so little that it follows what is around it.
  void release_outside() {
    constexpr double kLoose = 1e-6;
    for (int i = 0; i < deformation_.size(); ++i) {
      if (cloud_.is_inside(i)) continue;
      goals_[i].weight = 0;
      goals_[i].anchor = deformation_.positions()[i];
      goals_[i].anchor_weight = kLoose * cloud_.areas[i];
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
  const Context& context_;
  std::vector<Goal> goals_;
  std::vector<Foot> feet_;
};

}  // namespace

Registration register_onto(const PointCloud& cloud, Deformation& deformation,
                           const Projection& surface, std::span<const Point> anchors,
                           const RegistrationOptions& options, std::span<const Pin> pins,
                           const Context& context) {
  Registrar registrar(cloud, deformation, surface, anchors, options, pins, context);
  registrar.run();
  return registrar.result();
}

}  // namespace isomatch::elastic
