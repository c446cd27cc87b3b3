// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/correspondence.h"

namespace isomatch::results {

/// A sorted correspondence with the isometric distortion of each match.
struct MeasuredMatches {
  Correspondence matches;
  std::vector<double> distortion;
};

}  // namespace isomatch::results
