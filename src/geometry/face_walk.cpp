// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/face_walk.h"

#include <limits>

#include "geometry/closest_point.h"

namespace isomatch::transfer {

SurfacePoint FaceWalk::closest(const Point& p, std::span<const int> starts) const {
  FacePoint best{{}, std::numeric_limits<double>::infinity()};
  const auto try_face = [&](int face) {
    const FacePoint candidate = closest_point(mesh_, face, p);
    if (candidate.squared_distance < best.squared_distance) best = candidate;
  };
  for (int face : starts) try_face(face);
  for (int at = kNoFace; at != best.point.face;) {
    at = best.point.face;
    for (int v : mesh_.faces[at])
      for (int face : vertex_faces_[v]) try_face(face);
  }
  return best.point;
}

}  // namespace isomatch::transfer
