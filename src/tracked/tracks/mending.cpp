// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/mending.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "tracked/hypotheses/agreement.h"

namespace isomatch::tracked {
namespace {

/// How badly a node agrees where it is, and the place where it would agree best.
struct Check {
  float cost = 0;
  int best = 0;
  float best_cost = 0;
};

/// The node itself is no witness of where it belongs.
Check check(int node, int place, const Agreement& agreement, std::vector<float>& weights) {
  const float own = std::exchange(weights[node], 0.0F);
  const std::vector<float> costs = agreement.costs(node, weights);
  weights[node] = own;
  const auto least = std::ranges::min_element(costs);
  return {costs[place], static_cast<int>(least - costs.begin()), *least};
}

std::vector<Check> check_all(std::span<const int> places, const Agreement& agreement,
                             std::vector<float> weights) {
  std::vector<Check> checks;
  for (std::size_t i = 0; i < places.size(); ++i)
    checks.push_back(check(static_cast<int>(i), places[i], agreement, weights));
  return checks;
}

/// Little for the nodes that cost far more than the median.
std::vector<float> trusted(std::span<const double> areas, const std::vector<Check>& checks,
                           float tolerance) {
  std::vector<float> costs;
  for (const Check& check : checks) costs.push_back(check.cost);
  const auto median = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
  std::ranges::nth_element(costs, median);
  const float tolerable = tolerance * *median + 1e-6F;
  std::vector<float> weights;
  for (std::size_t i = 0; i < checks.size(); ++i)
    weights.push_back(static_cast<float>(areas[i]) /
                      (1 + std::pow(checks[i].cost / tolerable, 4.0F)));
  return weights;
}

}  // namespace

std::vector<int> mended(const Proxy& source, const Proxy& target, std::span<const double> areas,
                        std::vector<int> target_nodes, int places, const MendingOptions& options) {
  std::vector<int> source_nodes(target_nodes.size());
  std::iota(source_nodes.begin(), source_nodes.end(), 0);
  const std::vector<int> before = target_nodes;
  const Agreement agreement(source, target, source_nodes, before, places);
  const std::vector<float> alike(areas.begin(), areas.end());
  const std::vector<Check> first = check_all(before, agreement, alike);
  const std::vector<Check> checks =
      check_all(before, agreement, trusted(areas, first, options.tolerable));
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const Check& check = checks[i];
    if (check.best_cost < options.max_remaining * check.cost &&
        target.node_distance(check.best, before[i]) >= options.min_move)
      target_nodes[i] = check.best;
  }
  return target_nodes;
}

}  // namespace isomatch::tracked
