// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/mesh/mesh.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::elastic {

/// The vertex that is closer to `position` than its neighbours, reached from `start` by going from
/// vertex to vertex as long as that comes closer. Needs no index, but a start on the right part of
/// the surface.
int descend(int start, const Point& position, const Mesh& mesh, const IndexLists& vertex_faces);

}  // namespace isomatch::elastic
