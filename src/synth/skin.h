// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/mesh/mesh.h"
#include "random.h"
#include "synth/body.h"
#include "synth/corner_table.h"
#include "synth/pose.h"

namespace isomatch::synth {

/// A triangulated skin of a body in a pose.
struct Skin {
  std::vector<Face> faces;
  /// Positions in the pose and at rest.
  std::vector<Point> posed, rest;
};

/// Meshes the skin evenly, as seen in the pose, with exactly `vertices` vertices if these are at
/// most 40,000, otherwise with at most a few hundred more or less. O(N).
Skin mesh_skin(const Body& body, const Pose& pose, int vertices, Random& random,
               const Context& context);

}  // namespace isomatch::synth
