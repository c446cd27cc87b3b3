// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/measure/metrics.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"

namespace isomatch {

Coverage target_coverage(const Shape& source, const Shape& target, const Correspondence& matches) {
  const Surface& surface = *target.prepared().surface();
  std::vector<bool> hit(surface.num_vertices(), false);
  for (const Match& match : *on_surfaces(*source.prepared().surface(), surface, matches))
    hit[match.target] = true;
  int hits = 0;
  double area = 0;
  for (int v = 0; v < surface.num_vertices(); ++v) {
    if (!hit[v]) continue;
    ++hits;
    area += surface.vertex_areas[v];
  }
  return {static_cast<double>(hits) / surface.num_vertices(), area};
}

}  // namespace isomatch
