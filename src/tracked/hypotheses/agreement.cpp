// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/agreement.h"

#include <cmath>

namespace isomatch::tracked {
namespace {

constexpr float kClosenessOffset = 0.1F;

float closeness(float distance) { return 1 / (distance + kClosenessOffset); }

}  // namespace

Agreement::Agreement(const Proxy& source, const Proxy& target, std::span<const int> source_nodes,
                     std::span<const int> target_nodes, int places)
    : source_(source), source_nodes_(source_nodes), near_(target_nodes.size(), places) {
  for (std::size_t j = 0; j < target_nodes.size(); ++j)
    for (int t = 0; t < places; ++t)
      near_(j, t) = closeness(target.node_distance(target_nodes[j], t));
}

std::vector<float> Agreement::costs(int node, std::span<const float> weights) const {
  std::vector<float> costs(near_.cols(), 0.0F);
  for (std::size_t j = 0; j < source_nodes_.size(); ++j) {
    const float expected = closeness(source_.node_distance(source_nodes_[j], node));
    const float* values = near_.row(j).data();
    for (std::size_t t = 0; t < costs.size(); ++t)
      costs[t] += weights[j] * std::abs(expected - values[t]);
  }
  return costs;
}

}  // namespace isomatch::tracked
