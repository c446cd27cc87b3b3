// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>

#include "isomatch/context.h"
#include "isomatch/mesh/mesh.h"

/// Whether a mesh that was bent onto another, such as `TrackedMap::registered`, is still a sound
/// surface and covers the other.
namespace isomatch {

/// Shares in [0, 1].
struct RegisteredSurface {
  /// Of the triangles, those at a fold: the normal is more than 90 degrees from that of the
  /// neighbour across an edge where it is not on the source. A triangle that is turned over counts
  /// along with the neighbours that are not. Edges of more than two faces tell nothing.
  double folded = 0;
  /// Of the triangles, those whose area has become less than a tenth of what it was, both meshes
  /// being scaled to the same area.
  double squeezed = 0;
  /// Of the target's area, what is within .01 sqrt(area of the target) of the registered surface:
  /// half of what a tail or a finger is thick, so that what lies beside a limb does not reach it.
  double reach = 0;
};

/// Measures the surface of `registered`, the vertices of `source` moved onto `target` and in its
/// unit of length. Triangles without area, or with coordinates that are not finite, on the source
/// or the target do not count. Deterministic for any number of threads. Throws `InvalidInput` if a
/// mesh is invalid or there are not as many positions as vertices. O(N log N), but at least some
/// 20,000 searches however coarse the target is.
RegisteredSurface measure_registered(const Mesh& source, std::span<const Point> registered,
                                     const Mesh& target, const Context& context = {});

}  // namespace isomatch
