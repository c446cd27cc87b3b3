// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

#include "geometry/carried_point.h"
#include "geometry/walk.h"
#include "geometry/weld.h"
#include "isomatch/carry/transfer.h"
#include "isomatch/error.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

/// The one corner that counts, or -1.
int only_corner(const SurfacePoint& point) {
  for (int k = 0; k < 3; ++k)
    if (point.weights[k] == 1) return k;
  return -1;
}

}  // namespace

SurfaceMap transfer_points(const Mesh& source, const Mesh& target,
                           const SurfaceMap& source_to_target,
                           std::span<const SurfacePoint> points) {
  check_map(source_to_target, source.num_vertices(), target.num_faces());
  const WeldedMesh welded = weld(target);
  const IndexLists around = vertex_faces(welded.mesh);
  const auto carried = [&](const SurfacePoint& point) -> SurfacePoint {
    if (point.face == kNoFace) return {};
    if (point.face < 0 || point.face >= source.num_faces())
      throw InvalidInput("a point lies on a face that the source does not have");
    if (const int k = only_corner(point); k >= 0)
      return source_to_target[source.faces[point.face][k]];
    const CarriedPoint mean = carried_point(source, source_to_target, point, [&](int vertex) {
      return position(target, source_to_target[vertex]);
    });
    if (!mean.exists()) return {};
    return walk_to_point(welded.mesh, around, mean.faces, mean.position);
  };
  SurfaceMap result;
  result.reserve(points.size());
  for (const SurfacePoint& point : points) result.push_back(carried(point));
  return result;
}

}  // namespace isomatch
