// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>

#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {

/// Where a map leads a point between vertices, as `walk_to_point` needs it.
struct CarriedPoint {
  /// Weighted mean of where the corners of its face go.
  Point position{0, 0, 0};
  /// Faces on which the corners that count lie, the first in the place of others.
  std::array<int, 3> faces{kNoFace, kNoFace, kNoFace};

  /// Not where a corner that counts is unmatched.
  bool exists() const { return faces[0] != kNoFace; }
};

/// `point` is on `source` or none; `position_of` tells where a matched vertex of it goes.
template <class PositionOf>
CarriedPoint carried_point(const Mesh& source, const SurfaceMap& source_to_target,
                           const SurfacePoint& point, const PositionOf& position_of) {
  CarriedPoint carried;
  if (point.face == kNoFace) return carried;
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    if (point.weights[k] == 0) continue;
    const int vertex = source.faces[point.face][k];
    if (source_to_target[vertex].face == kNoFace) return {};
    carried.position += point.weights[k] * position_of(vertex);
    carried.faces[count++] = source_to_target[vertex].face;
  }
  for (; count < 3; ++count) carried.faces[count] = carried.faces[0];
  return carried;
}

}  // namespace isomatch
