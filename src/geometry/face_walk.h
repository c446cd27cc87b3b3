// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>

#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::transfer {

/// Finds points on a surface by walking there, so that parts which merely come close in space are
/// not mistaken for the place.
class FaceWalk {
 public:
  /// Keeps a reference to `mesh`. Its split vertices should have been welded.
  explicit FaceWalk(const Mesh& mesh) : mesh_(mesh), vertex_faces_(vertex_faces(mesh)) {}

  /// The point that is closest to `p` on the best of the faces `starts`, then on the faces around
  /// it, and so on as long as that comes closer. Of equally close faces the first counts.
  SurfacePoint closest(const Point& p, std::span<const int> starts) const;

 private:
  const Mesh& mesh_;
  IndexLists vertex_faces_;
};

}  // namespace isomatch::transfer
