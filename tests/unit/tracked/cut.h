// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <algorithm>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::test {

/// The mesh without the faces that reach below the plane along an axis below which a share of the
/// vertices lies. Vertices keep their numbers.
inline Mesh cut(Mesh mesh, int axis, double share) {
  std::vector<double> heights;
  for (const Point& p : mesh.vertices) heights.push_back(p[axis]);
  const auto place =
      heights.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(heights.size()));
  std::ranges::nth_element(heights, place);
  const double least = *place;
  std::erase_if(mesh.faces, [&](const Face& face) {
    return std::ranges::any_of(face, [&](int v) { return mesh.vertices[v][axis] < least; });
  });
  return mesh;
}

}  // namespace isomatch::test
