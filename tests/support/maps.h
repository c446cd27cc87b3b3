// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/maps/surface_map.h"

/// Maps whose values are known.
namespace isomatch::test {

/// Each vertex at the corner of its first face; no point for vertices without a face.
inline SurfaceMap identity_map(const Mesh& mesh) {
  SurfaceMap map(mesh.vertices.size());
  for (int f = 0; f < mesh.num_faces(); ++f) {
    for (int k = 0; k < 3; ++k) {
      SurfacePoint& point = map[mesh.faces[f][k]];
      if (point.face >= 0) continue;
      point.face = f;
      point.weights[k] = 1;
    }
  }
  return map;
}

}  // namespace isomatch::test
