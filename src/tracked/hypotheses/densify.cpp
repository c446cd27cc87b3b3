// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/densify.h"

#include <algorithm>

#include "tracked/hypotheses/agreement.h"

namespace isomatch::tracked {

std::vector<int> densify(const Proxy& source, const Proxy& target, const Hypothesis& hypothesis,
                         int count) {
  const Agreement agreement(source, target, hypothesis.source_nodes, hypothesis.target_nodes,
                            target.num_nodes());
  const std::vector<float> alike(hypothesis.target_nodes.size(), 1.0F);
  std::vector<int> map(count);
  for (int i = 0; i < count; ++i) {
    const std::vector<float> costs = agreement.costs(i, alike);
    map[i] = static_cast<int>(std::ranges::min_element(costs) - costs.begin());
  }
  return map;
}

}  // namespace isomatch::tracked
