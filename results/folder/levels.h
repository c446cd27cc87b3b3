// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "results/folder/measured_matches.h"
#include "results/folder/result.h"

namespace isomatch::results {

/// One level of the paper's method, in the numbers of the input files: xi(k) and xi(k,1).
struct ResultLevel {
  MeasuredMatches many_to_many, many_to_one;
};

/// The levels of a result, from 0; none if the method has none. Throws `BadFile` if a file is
/// missing or malformed.
std::vector<ResultLevel> load_levels(const MatchResult& result);

}  // namespace isomatch::results
