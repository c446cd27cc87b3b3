// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/context.h"
#include "isomatch/maps/surface_map.h"

namespace isomatch {

struct InversionOptions {
  /// A target vertex that is farther than this from everything that the source covers has no point.
  /// Relative to sqrt(area) of the target: wide enough for the gaps between the images of a coarse
  /// source, narrow enough for the nearest limb to be out of reach.
  double max_distance = 0.05;
  /// How much the angle between normals counts against distance: opposite normals are as bad as
  /// twice this, relative to sqrt(area) of the target. It keeps the sides of a thin sheet apart.
  double normal_weight = 0.05;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

/// A map of the other direction: for each target vertex the point of the source whose image is
/// closest. The images of a source face's corners span a triangle, whose points are the images of
/// the face's; faces with an unmatched corner have none. The inverse of a map to equal meshes is
/// the equal map. O((M + N) log N), deterministic for any number of threads. Throws `InvalidInput`
/// if the map does not fit the meshes.
SurfaceMap invert_map(const Mesh& source, const Mesh& target, const SurfaceMap& source_to_target,
                      const InversionOptions& options = {}, const Context& context = {});

}  // namespace isomatch
