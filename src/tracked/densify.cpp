// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/densify.h"

#include <algorithm>
#include <cmath>

namespace isomatch::tracked {
namespace {

constexpr float kClosenessOffset = 0.1F;

float closeness(float distance) { return 1 / (distance + kClosenessOffset); }

}  // namespace

std::vector<int> densify(const Proxy& source, const Proxy& target, const Hypothesis& hypothesis,
                         int count) {
  const int n = target.num_nodes();
  const int landmarks = static_cast<int>(hypothesis.target_nodes.size());
  FloatMatrix near(landmarks, n);
  for (int j = 0; j < landmarks; ++j)
    for (int t = 0; t < n; ++t)
      near(j, t) = closeness(target.node_distance(hypothesis.target_nodes[j], t));
  std::vector<int> map(count);
  std::vector<float> cost(n);
  for (int i = 0; i < count; ++i) {
    std::ranges::fill(cost, 0.0F);
    for (int j = 0; j < landmarks; ++j) {
      const float expected = closeness(source.node_distance(hypothesis.source_nodes[j], i));
      const float* values = near.row(j).data();
      for (int t = 0; t < n; ++t) cost[t] += std::abs(expected - values[t]);
    }
    map[i] = static_cast<int>(std::ranges::min_element(cost) - cost.begin());
  }
  return map;
}

}  // namespace isomatch::tracked
