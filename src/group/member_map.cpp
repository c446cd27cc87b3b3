// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <vector>

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
    map.emplace_back();
    if (point.face == kNoFace) continue;
    // Interpolated between registered vertices, which do not fold, and not between their images.
    Point registered(0, 0, 0);
    std::vector<int> starts;
    bool known = true;
    for (int k = 0; k < 3; ++k) {
      if (point.weights[k] == 0) continue;
      const int vertex = followed.faces[point.face][k];
      known = known && onto.from_template[vertex].face != kNoFace;
      if (!known) break;
      registered += point.weights[k] * onto.registered[vertex];
      starts.push_back(onto.from_template[vertex].face);
    }
    if (known) map.back() = walk_to_point(welded.mesh, around, starts, registered);
  }
  return map;
}

}  // namespace isomatch
