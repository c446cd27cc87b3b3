// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// Linear between the corners of its face: what vectors at the vertices of a mesh are at `point`,
/// which must have a face. Of unit normals it is shorter than they are.
template <class Vector>
Vector interpolated(const Mesh& mesh, const std::vector<Vector>& values,
                    const SurfacePoint& point) {
  const Face& face = mesh.faces[point.face];
  Vector sum = Vector::Zero();
  for (int k = 0; k < 3; ++k) sum += point.weights[k] * values[face[k]];
  return sum;
}

}  // namespace isomatch
