// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "elastic/deformation.h"
#include "elastic/projection.h"

namespace isomatch::elastic {

struct RegistrationOptions {
  /// The elastic energy weighs the square of these lengths, one step after the other.
  double first_length = 0.3, last_length = 0.02;
  int steps = 20;
  int initial_steps = 5;
  int iterations = 2;
  double rotation_smoothness = 0.5;
  double min_cosine = 0.3;
  double tangential = 0.1;
};

struct RegistrationResult {
  std::vector<Foot> feet;
  double elastic = 0, distance = 0, normal = 0;
};

/// Deforms a graph of points onto a surface, starting at `targets`.
RegistrationResult register_onto(Deformation& deformation, std::span<const Point> normals,
                                 std::span<const double> areas, const Projection& surface,
                                 std::span<const Point> targets,
                                 const RegistrationOptions& options);

}  // namespace isomatch::elastic
