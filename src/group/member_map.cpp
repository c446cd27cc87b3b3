// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/carried_point.h"
#include "geometry/walk.h"
#include "geometry/weld.h"
#include "isomatch/group/group.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {

SurfaceMap member_map(std::span<const Shape> shapes, const GroupResult& group, int source,
                      int target) {
  const GroupMember& onto = group.members[target];
  const Mesh& followed = shapes[group.template_shape].mesh();
  const WeldedMesh welded = weld(shapes[target].mesh());
  const IndexLists around = vertex_faces(welded.mesh);
  SurfaceMap map;
  for (const SurfacePoint& point : group.members[source].to_template) {
    // Interpolated between registered vertices, which do not fold, and not between their images.
    const CarriedPoint carried = carried_point(followed, onto.from_template, point,
                                               [&](int vertex) { return onto.registered[vertex]; });
    map.push_back(carried.exists()
                      ? walk_to_point(welded.mesh, around, carried.faces, carried.position)
                      : SurfacePoint());
  }
  return map;
}

}  // namespace isomatch
