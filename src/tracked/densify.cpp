// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/densify.h"

#include <algorithm>
#include <cmath>

namespace isomatch::tracked {

std::vector<int> densify(const Proxy& source, const std::vector<int>& source_landmarks,
                         const Proxy& target, const std::vector<int>& target_landmarks,
                         const DensifyOptions& options, const Context& context) {
  std::vector<int> map(source.nodes.size());
  const int n = target.num_vertices();
  const int rows = static_cast<int>(target_landmarks.size());
  const auto closeness = [&](float distance) { return 1 / (distance + options.offset); };
  FloatMatrix near(rows, n);
  for (int j = 0; j < rows; ++j)
    near.row(j) = target.distances.row(target_landmarks[j]).unaryExpr(closeness);
#pragma omp parallel num_threads(context.threads)
  {
    std::vector<float> cost(n);
#pragma omp for schedule(static)
    for (int i = 0; i < source.num_nodes(); ++i) {
      std::ranges::fill(cost, 0.0F);
      for (int j = 0; j < rows; ++j) {
        const float expected = closeness(source.node_distance(source_landmarks[j], i));
        const float* values = near.row(j).data();
        for (int v = 0; v < n; ++v) cost[v] += std::abs(expected - values[v]);
      }
      map[i] = static_cast<int>(std::ranges::min_element(cost) - cost.begin());
    }
  }
  return map;
}

}  // namespace isomatch::tracked
