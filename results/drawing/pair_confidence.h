// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <vector>

#include "results/folder/result.h"

namespace isomatch::results {

/// How sure the points of the vertices of both shapes are, in [0, 1]; NaN where there is none.
struct PairConfidence {
  std::vector<float> source, target;
};

/// The confidence of `map`; nothing if the method does not tell. Without one of the target's own, a
/// vertex has that of the source vertex that lands nearest. `matched` says which target vertices
/// have a point.
std::optional<PairConfidence> pair_confidence(const MatchResult& result, const ResultMap& map,
                                              const std::vector<bool>& matched);

}  // namespace isomatch::results
