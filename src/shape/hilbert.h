// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// The indices of `points` in the order in which a Hilbert curve through their bounding cube, of
/// 2^21 cells a side, meets them. Points of one cell are sorted by coordinates, so that coinciding
/// points are adjacent, then by index. O(N log N).
std::vector<int> hilbert_order(std::span<const Point> points);

}  // namespace isomatch
