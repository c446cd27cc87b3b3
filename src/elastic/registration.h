// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "elastic/deformation.h"
#include "elastic/projection.h"

namespace isomatch::elastic {

/// Lengths are over sqrt(area). docs/results/options.md has what other numbers do.
struct RegistrationOptions {
  /// The elastic energy weighs the square of a length that falls geometrically.
  double first_length = 0.3, last_length = 0.02;
  /// Steps towards the anchors alone, then steps towards the surface as well.
  int anchor_steps = 5, surface_steps = 15;
  /// Alternations between projection, positions and rotations in a step.
  int iterations = 4;
  /// How much a point that is drawn to the surface resists sliding along it, against being drawn:
  /// without, the system may be singular.
  double friction = 0.1;
  /// How much the rotations of neighbours agree, against fitting the positions.
  double rotation_smoothness = 0.5;
  /// Points whose normal deviates more from the surface's, by 70 degrees, are on another side of a
  /// thin limb. They are drawn to it with this weight only, which keeps the system regular.
  double min_cosine = 0.3, incompatible_weight = 1e-3;
  /// Fits of the rotations to the anchors before anything moves: rotations of neighbours spread by
  /// a ring of points each.
  int initial_rotations = 10;
  /// Where something may be missing, points are drawn only to what is at most as far as this, or as
  /// the length of the step, and not to the rim.
  double reach = 0.06;
};

struct Registration {
  std::vector<Foot> feet;
  /// Whether each point was drawn to its foot, see `RegistrationOptions::reach`.
  std::vector<bool> met;
  /// Elastic energy; distance to the surface and deviation of normals, 1 - cosine, integrated over
  /// the points inside.
  double energy = 0, distance = 0, deviation = 0;
};

/// Points with normals and the area that each stands for.
struct PointCloud {
  std::vector<Point> positions, normals;
  std::vector<double> areas;
  std::vector<Features> features;
  /// Those that have a counterpart, as far as is known. Others follow these. All if it is empty.
  std::vector<bool> inside;

  bool is_inside(int point) const { return inside.empty() || inside[point]; }
};

/// A point of the cloud that goes to a known place.
struct Pin {
  int point;
  Point position;
};

/// Deforms a cloud onto a surface, beginning at `anchors`. The threads of `context` help where a
/// single cloud is registered at a time.
Registration register_onto(const PointCloud& cloud, Deformation& deformation,
                           const Projection& surface, std::span<const Point> anchors,
                           const RegistrationOptions& options, std::span<const Pin> pins,
                           const Context& context);

}  // namespace isomatch::elastic
