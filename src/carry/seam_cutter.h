// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "carry/charts.h"
#include "isomatch/maps/surface_map.h"

namespace isomatch::transfer {

/// A mesh and where its vertices lie on another.
struct MappedMesh {
  Mesh mesh;
  SurfaceMap map;
};

/// Cuts faces of `target` where seams of `charts`, on the source, cross their edges. New vertices
/// come after the old ones. Faces that meet in an edge are cut at the same place.
MappedMesh cut_along_seams(const Charts& charts, const Mesh& target,
                           const SurfaceMap& target_to_source);

}  // namespace isomatch::transfer
