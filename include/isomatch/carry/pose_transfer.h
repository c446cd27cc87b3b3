// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "isomatch/maps/surface_map.h"

namespace isomatch {

struct PoseTransferOptions {
  /// The target as it is given has the pose of the source as it is given, and moves as the source
  /// does from there, in its own coordinates: a frame that is the source as it is given leaves it
  /// as it is. Otherwise it is in another pose, which the map tells, and takes the poses of
  /// the source's frames themselves.
  bool same_rest_pose = false;
};

/// Deformation transfer (Sumner and Popovic 2004): poses of the source, as positions of its
/// vertices, become poses of the target, which keeps its own shape.
///
/// Each target face deforms as the source face in which its centre lies does, after a rotation into
/// the source's rest pose that is fitted around it; positions follow by least squares, with one
/// sparse Cholesky factorisation for all frames. Faces with an unmatched corner follow the nearest
/// ones that are matched, along the surface; unmatched components move as stiffly as the nearest
/// carried vertex says. Vertices split at seams stay together. Unless both share a rest pose,
/// positions come out in the source's coordinates, distances from their origin times the ratio of
/// sizes: what stands on a floor at the origin goes on doing so.
///
/// A target equal to the source follows any frame exactly, up to slivers.
class PoseTransfer {
 public:
  /// Throws `InvalidInput` if the map does not fit or leaves no target face, and `SolverFailure` if
  /// the target's faces are too badly shaped. About O(N log N) as a rule.
  PoseTransfer(const Mesh& source, const Mesh& target, const SurfaceMap& target_to_source,
               const PoseTransferOptions& options = {});
  ~PoseTransfer();
  PoseTransfer(PoseTransfer&&) noexcept;

  /// The target's vertices in the pose in which the source's are at `frame`. Throws `InvalidInput`
  /// if that is not a finite position for each. O(N) as a rule.
  std::vector<Point> operator()(std::span<const Point> frame) const;

  /// Target vertices of which no face is matched, so that they only follow.
  const std::vector<bool>& followers() const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace isomatch
