// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "isomatch/maps/surface_map.h"

/// Carrying over what belongs to the vertices of one mesh to another one that a map connects it
/// with. What lies on the source comes to the target by `target_to_source`, which says for each
/// target vertex where on the source it lies; landmarks alone take the map of their own direction.
/// What is unmatched stays unknown: nothing is invented there. Swap the meshes to carry the other
/// way; `invert_map` makes a map of the missing direction.
///
/// Meshes are those of the files. All functions cost O(N) unless noted, are deterministic, and
/// throw `InvalidInput` if a map or the values do not fit the meshes.
namespace isomatch {

/// Values at source vertices (a row each, as many columns as one likes: a scalar, a colour, a
/// vector) as values at target vertices, interpolated linearly over each source face. NaN where
/// unmatched. Vectors are not turned with the surface.
Eigen::MatrixXd transfer_values(const Mesh& source, const SurfaceMap& target_to_source,
                                const Eigen::MatrixXd& values);

inline constexpr int kNoLabel = -1;

/// Labels of source vertices as labels of target vertices. The corners of the source face vote with
/// their barycentric weights; of equal votes the lowest label wins. A corner of `kNoLabel` does not
/// vote. `kNoLabel` where unmatched or nobody votes.
std::vector<int> transfer_labels(const Mesh& source, const SurfaceMap& target_to_source,
                                 std::span<const int> labels);

/// How much a bone moves a vertex.
struct Influence {
  int bone;
  double weight;

  bool operator==(const Influence&) const = default;
};

/// The influences of each vertex, by rising bone.
using SkinWeights = std::vector<std::vector<Influence>>;

/// Skinning weights, interpolated; of the influences that come together at a target vertex the
/// largest are kept (of equal ones the lower bone), at most as many as a source vertex has at most,
/// and they sum to 1. None where unmatched. Throws `InvalidInput` too if a weight is negative or
/// not finite, or a bone repeats at a vertex.
SkinWeights transfer_skin(const Mesh& source, const SurfaceMap& target_to_source,
                          const SkinWeights& weights);

/// Points of the source, such as landmarks, on the target. A point between vertices is where their
/// images' weighted mean comes to lie on the target's surface near them. No point where a corner
/// that counts is unmatched. O(N + P).
SurfaceMap transfer_points(const Mesh& source, const Mesh& target,
                           const SurfaceMap& source_to_target,
                           std::span<const SurfacePoint> points);

}  // namespace isomatch
