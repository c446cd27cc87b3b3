// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "carry/checks.h"

#include <fmt/format.h>

#include <utility>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::transfer {

void check_map(int from_vertices, const Mesh& onto, const SurfaceMap& map) {
  if (std::cmp_not_equal(map.size(), from_vertices))
    throw InvalidInput(
        fmt::format("the map has {} points for {} vertices", map.size(), from_vertices));
  for (const SurfacePoint& point : map) {
    if (point.face < kNoFace || point.face >= onto.num_faces())
      throw InvalidInput(fmt::format("the map leads to face {} of a mesh of {} faces", point.face,
                                     onto.num_faces()));
  }
}

}  // namespace isomatch::transfer
