// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/mesh/mesh.h"
#include "random.h"

namespace isomatch::synth {

/// Removes the faces of a closed manifold that reach beyond a plane of random direction, placed so
/// that the largest component of the others lacks `share` of the area, within 1 % of the area
/// wherever one of 20 directions allows it. The vertices stay. O(N log N) a direction.
Mesh cut_by_plane(Mesh mesh, double share, Random& random);

}  // namespace isomatch::synth
