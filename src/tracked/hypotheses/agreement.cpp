// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/agreement.h"

#include <cmath>

#include "wide_vectors.h"

namespace isomatch::tracked {
namespace {

constexpr float kClosenessOffset = 0.1F;

float closeness(float distance) { return 1 / (distance + kClosenessOffset); }

/// Adds to each of `costs` weight times the deviation of a value from what is expected.
ISOMATCH_WIDE_VECTORS void add_deviations(const float* values, std::size_t count, float expected,
                                          float weight, float* costs) {
  for (std::size_t t = 0; t < count; ++t) costs[t] += weight * std::abs(expected - values[t]);
}

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
    add_deviations(near_.row(j).data(), costs.size(), expected, weights[j], costs.data());
  }
  return costs;
}

}  // namespace isomatch::tracked
