// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>

#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"

/// Searches on a surface by walking there as long as that comes closer. They need no index, but a
/// start on the right part of the surface; parts that merely come close in space are not mistaken
/// for it. Split vertices should have been welded.
namespace isomatch {

/// The vertex that is closer to `p` than its neighbours, reached from vertex `start`.
int walk_to_vertex(const Mesh& mesh, const IndexLists& vertex_faces, int start, const Point& p);

/// The point that is closest to `p` on the best of the faces `starts`, then on the faces around
/// it, and so on. Of equally close faces the first counts.
SurfacePoint walk_to_point(const Mesh& mesh, const IndexLists& vertex_faces,
                           std::span<const int> starts, const Point& p);

}  // namespace isomatch
