// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

namespace isomatch {

/// One pair of corresponding vertices, 0-based.
struct Match {
  int source;
  int target;

  auto operator<=>(const Match&) const = default;
};

/// A relation between the vertices of two meshes (the paper's xi), in general many-to-many. Sorted
/// by source, then target, without repetition, unless a function says otherwise.
using Correspondence = std::vector<Match>;

/// A map from every source vertex to a target vertex, `kUnmatched` where there is none. Always
/// named by its direction, as in `source_to_target`.
using VertexMap = std::vector<int>;
inline constexpr int kUnmatched = -1;

/// The matches of a map.
Correspondence to_correspondence(const VertexMap& source_to_target);

}  // namespace isomatch
