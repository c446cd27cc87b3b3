// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/untorn.h"

#include <utility>

namespace isomatch::tracked {

std::vector<int> untorn(const std::vector<int>& before, std::vector<int> after,
                        const IndexLists& neighbours, const std::vector<Point>& positions,
                        const Options& options) {
  const auto spread = [&](const std::vector<int>& places, int i) {
    double sum = 0;
    for (int j : neighbours[i]) sum += (positions[places[i]] - positions[places[j]]).squaredNorm();
    return sum;
  };
  const std::vector<int> step = after;
  for (int i = 0; std::cmp_less(i, step.size()); ++i) {
    const double move = (positions[step[i]] - positions[before[i]]).norm();
    if (move > options.torn_move && spread(step, i) > options.torn_spread * spread(before, i))
      after[i] = before[i];
  }
  return after;
}

}  // namespace isomatch::tracked
