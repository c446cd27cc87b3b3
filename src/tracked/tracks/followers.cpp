// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/followers.h"

#include <optional>

#include "geometry/closest_point.h"
#include "geometry/kd_tree.h"
#include "shape/numbers.h"

namespace isomatch::tracked {
namespace {

/// Vertices of the mesh that have a face but are not part of the surface.
std::vector<int> followers(const Mesh& mesh, const Surface& surface) {
  std::vector<bool> has_face(mesh.vertices.size(), false);
  for (const Face& face : mesh.faces)
    for (int v : face) has_face[v] = true;
  std::vector<int> vertices;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (has_face[v] && surface.surface_vertex[v] == kNoVertex) vertices.push_back(v);
  return vertices;
}

}  // namespace

void match_followers(const Mesh& source, const Surface& source_surface,
                     const Surface& target_surface, const std::vector<Point>& moved, double reach,
                     SurfaceMap& map) {
  const Mesh& goal = target_surface.mesh;
  std::optional<KdTree<3>> tree;  // As a rule there are none.
  for (const int v : followers(source, source_surface)) {
    if (!moved[v].allFinite()) continue;
    if (!tree) tree.emplace(goal.vertices);
    const Point p = (moved[v] - target_surface.centre) / target_surface.scale;
    const SurfacePoint point =
        closest_point_around(goal, target_surface.faces, tree->nearest(p), p);
    if ((position(goal, point) - p).norm() * target_surface.scale <= reach)
      map[v] = to_input(target_surface, point);
  }
}

}  // namespace isomatch::tracked
