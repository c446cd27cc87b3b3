// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>

#include "isomatch/mesh/mesh.h"

/// Irregular meshes from seeded generators, manifold and consistently oriented, for comparisons
/// with exact algorithms that need both; only `triangle_soup` is neither.
namespace isomatch::test {

/// A torus of radii 1 and .4 as a jittered grid of `around` x `across` vertices, with its diagonals
/// turned at random. `jitter` is in grid cells; up to .3 no triangle turns over.
Mesh jittered_torus(int around, int across, double jitter, std::uint64_t seed);

/// The same torus with every vertex moved along the normal by up to `roughness`.
Mesh rough_torus(int around, int across, double roughness, std::uint64_t seed);

/// A torus in which every third vertex was moved to within `gap` grid cells of its neighbour, so
/// that most triangles are slivers of that aspect ratio or have two nearly equal corners.
Mesh sliver_torus(int around, int across, double gap, std::uint64_t seed);

/// A bumpy unit square of n x n vertices with jittered vertices, random diagonals and square holes.
Mesh holed_terrain(int n, double bumpiness, std::uint64_t seed);

/// Random triangles on random points of the unit cube: non-manifold, in several components, with
/// repeated faces and vertices of a face.
Mesh triangle_soup(int num_vertices, int num_faces, std::uint64_t seed);

}  // namespace isomatch::test
