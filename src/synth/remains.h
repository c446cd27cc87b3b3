// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/synth.h"

namespace isomatch::synth {

/// Of each vertex the number of its edges that have one face. O(N).
std::vector<int> open_edges(const Mesh& mesh);

/// What remains of a closed manifold after faces were removed: the component of largest area, of
/// equal ones the one with the lowest face, also without the faces around vertices in which parts
/// touch that share no edge there, so that every border is a simple loop. Vertices and the order of
/// faces stay. O(N) a round of such vertices, of which there are one or two.
Mesh sound_remains(Mesh mesh);

/// Drops the vertices without a face, renumbers the others in their order, and has the truths say
/// `kUnmatched` for what is gone. O(N).
void drop_unused_vertices(SynthShape& shape);

}  // namespace isomatch::synth
