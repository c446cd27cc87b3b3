// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/surface_map.h"

namespace isomatch::transfer {

/// How a target lies against the source's rest pose.
struct RestPose {
  /// For each target face the rotation that turns it into the source's rest pose.
  std::vector<Eigen::Matrix3d> rotations;
  /// Length on the target for one on the source.
  double scale = 1;
};

/// Rotations are fitted to where the edges around each face go, two rings wide: narrower, the noise
/// of a map shows; wider, joints get stiff. Faces around which nothing is matched are not turned.
RestPose fit_rest_pose(const Mesh& source, const Mesh& target, const SurfaceMap& target_to_source);

}  // namespace isomatch::transfer
