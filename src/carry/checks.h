// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/maps/surface_map.h"

namespace isomatch::transfer {

/// Throws `InvalidInput` unless `map` leads from a mesh of `from_vertices` vertices to faces of
/// `onto`.
void check_map(int from_vertices, const Mesh& onto, const SurfaceMap& map);

}  // namespace isomatch::transfer
