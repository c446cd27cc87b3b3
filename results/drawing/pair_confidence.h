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

/// The confidence of `map`; nothing if the method does not tell. Target vertices have their own, or
/// that of the source vertex which lands nearest if the folder has none of the target or the
/// inverse map has no point for them; none if they are not `matched`.
std::optional<PairConfidence> pair_confidence(const MatchResult& result, const ResultMap& map,
                                              const std::vector<bool>& matched);

}  // namespace isomatch::results
