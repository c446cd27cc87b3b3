// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/measure/metrics.h"
#include "measure/checks.h"

namespace isomatch {

Coverage target_coverage(const Shape& target, const Correspondence& matches) {
  check_targets(target, matches);
  std::vector<bool> hit(target.num_vertices(), false);
  for (const Match& match : matches) hit[match.target] = true;
  int hits = 0;
  double area = 0;
  for (int v = 0; v < target.num_vertices(); ++v) {
    if (!hit[v]) continue;
    ++hits;
    area += target.vertex_areas[v];
  }
  return {static_cast<double>(hits) / target.num_vertices(), area / target.surface.area};
}

}  // namespace isomatch
