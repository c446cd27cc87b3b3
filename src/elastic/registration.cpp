// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/registration.h"

#include <cmath>
#include <numeric>

namespace isomatch::elastic {

RegistrationResult register_onto(Deformation& deformation, std::span<const Point> normals,
                                 std::span<const double> areas, const Projection& surface,
                                 std::span<const Point> targets,
                                 const RegistrationOptions& options) {
  const int n = deformation.size();
  std::vector<Goal> goals(n);
  for (int i = 0; i < n; ++i) goals[i] = {targets[i], Point::Zero(), areas[i], 1};
  RegistrationResult result;
  result.feet.resize(n);
  deformation.set_positions({targets.begin(), targets.end()});
  const auto project = [&] {
    for (int i = 0; i < n; ++i)
      result.feet[i] =
          surface(deformation.positions()[i], deformation.rotations()[i] * normals[i]);
  };
  double length = options.first_length;
  const double ratio = std::pow(options.last_length / options.first_length,
                                1.0 / std::max(1, options.steps - 1));
  for (int i = 0; i < 10; ++i) deformation.fit_rotations(options.rotation_smoothness);
  for (int step = 0; step < options.steps; ++step, length *= ratio) {
    for (int k = 0; k < options.iterations; ++k) {
      if (step >= options.initial_steps) {
        project();
        for (int i = 0; i < n; ++i) {
          const double cosine =
              result.feet[i].normal.dot(deformation.rotations()[i] * normals[i]);
          goals[i] = {result.feet[i].position, result.feet[i].normal,
                      areas[i] * (cosine < options.min_cosine ? 1e-3 : 1.0), options.tangential};
        }
      }
      deformation.fit_positions(goals, length * length);
      deformation.fit_rotations(options.rotation_smoothness);
    }
  }
  project();
  const std::vector<double> energies = deformation.energies();
  result.elastic = std::accumulate(energies.begin(), energies.end(), 0.0);
  for (int i = 0; i < n; ++i) {
    result.distance += areas[i] * (deformation.positions()[i] - result.feet[i].position).norm();
    result.normal += areas[i] * (1 - result.feet[i].normal.dot(deformation.rotations()[i] * normals[i]));
  }
  return result;
}

}  // namespace isomatch::elastic
