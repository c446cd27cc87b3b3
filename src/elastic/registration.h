// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "elastic/deformation.h"
#include "elastic/projection.h"

namespace isomatch::elastic {

/// Lengths are in units of sqrt(area).
struct RegistrationOptions {
  /// The elastic energy weighs the square of a length that falls geometrically.
  double first_length = 0.3, last_length = 0.02;
  /// Steps towards the anchors alone, then steps towards the surface as well.
  int anchor_steps = 5, surface_steps = 15;
  /// Alternations between projection, positions and rotations in a step.
  int iterations = 4;
  /// Weight of the anchors in the second phase. If negative, the points slide along the surface
  /// with this much friction instead.
  double anchor_weight = -0.1;
  double rotation_smoothness = 0.5;
  /// Points whose normal deviates more from the surface's are not drawn to it.
  double min_cosine = 0.3;
};

struct Registration {
  std::vector<Foot> feet;
  /// Elastic energy, mean distance to the surface and mean deviation of normals, 1 - cosine.
  double energy = 0, distance = 0, deviation = 0;
};

/// Points with normals and the area that each stands for.
struct PointCloud {
  std::vector<Point> positions, normals;
  std::vector<double> areas;
  std::vector<Features> features;
};

/// A point of the cloud that goes to a known place.
struct Pin {
  int point;
  Point position;
};

/// Deforms a cloud onto a surface, beginning at `anchors`.
Registration register_onto(const PointCloud& cloud, Deformation& deformation,
                           const Projection& surface, std::span<const Point> anchors,
                           const RegistrationOptions& options, std::span<const Pin> pins = {});

}  // namespace isomatch::elastic
