// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/context.h"
#include "isomatch/mesh/mesh.h"
#include "random.h"
#include "synth/body.h"

namespace isomatch::synth {

/// Triangulates the skin of `body` by marching tetrahedra on a lattice of the given spacing, turned
/// and shifted at random. The mesh is closed, manifold and oriented outwards, with vertices on the
/// skin, but its triangles are uneven. About 4.5 area / spacing^2 vertices.
Mesh contour(const Body& body, double spacing, Random& random, const Context& context);

}  // namespace isomatch::synth
