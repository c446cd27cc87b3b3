// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace isomatch::tracked {
namespace {

std::vector<double> integral_distances(const Proxy& proxy) {
  std::vector<double> integral(proxy.num_measured(), 0.0);
  const std::vector<double> areas = vertex_areas(proxy.mesh);
  for (int a = 0; a < proxy.num_measured(); ++a)
    for (int v = 0; v < proxy.num_vertices(); ++v) integral[a] += areas[v] * proxy.distances(a, v);
  return integral;
}

struct Seed {
  double score;
  Correspondence matches;

  bool operator<(const Seed& other) const {
    return score != other.score ? score > other.score : matches < other.matches;
  }
};

/// Depth-first search over the matches of one source tip after the other.
class SeedSearch {
 public:
  SeedSearch(const Proxy& source, const std::vector<int>& source_tips, const Proxy& target,
             const std::vector<int>& target_tips, const SeedOptions& options)
      : source_(source),
        target_(target),
        source_tips_(source_tips),
        target_tips_(target_tips),
        options_(options),
        used_(target_tips.size(), false) {}

  std::vector<Correspondence> run(int fixed) {
    for (int i = 0; i < fixed; ++i) {
      used_[i] = true;
      matches_.push_back({source_tips_[i], target_tips_[i]});
    }
    min_matches_ = std::max(options_.min_matches, fixed);
    visit(fixed, 0);
    std::vector<Correspondence> result;
    for (; !best_.empty(); best_.pop()) result.push_back(best_.top().matches);
    std::ranges::reverse(result);
    return result;
  }

 private:
  bool is_full() const { return static_cast<int>(best_.size()) >= options_.max_seeds; }

  /// The most that the tips from `tip` on can add.
  double bound(std::size_t tip) const {
    double sum = 0;
    for (std::size_t n = matches_.size(); tip < source_tips_.size(); ++tip, ++n)
      sum += options_.neutral_difference * static_cast<double>(n);
    return sum;
  }

  void visit(std::size_t tip, double score) {
    if (++visits_ > options_.max_visits) return;
    if (is_full() && score + bound(tip) < best_.top().score) return;
    if (tip == source_tips_.size()) {
      keep(score);
      return;
    }
    for (std::size_t t = 0; t < target_tips_.size(); ++t) {
      if (used_[t]) continue;
      double gain = 0;
      if (!compatible(source_tips_[tip], target_tips_[t], gain)) continue;
      used_[t] = true;
      matches_.push_back({source_tips_[tip], target_tips_[t]});
      visit(tip + 1, score + gain);
      matches_.pop_back();
      used_[t] = false;
    }
    visit(tip + 1, score);
  }

  bool compatible(int s, int t, double& gain) const {
    for (const Match& other : matches_) {
      const double difference = sure_difference(s, t, other);
      if (difference > options_.max_difference) return false;
      gain += options_.neutral_difference - difference;
    }
    return true;
  }

  /// What the distances differ by at least on the whole shapes.
  double sure_difference(int s, int t, const Match& other) const {
    const float source = source_.node_distance(s, other.source),
                target = target_.node_distance(t, other.target);
    return std::max({0.0F, source_.least_distance(s, other.source) - target,
                     target_.least_distance(t, other.target) - source});
  }

  void keep(double score) {
    if (static_cast<int>(matches_.size()) < min_matches_) return;
    best_.push({score, matches_});
    if (static_cast<int>(best_.size()) > options_.max_seeds) best_.pop();
  }

  const Proxy& source_;
  const Proxy& target_;
  const std::vector<int>& source_tips_;
  const std::vector<int>& target_tips_;
  const SeedOptions& options_;
  std::vector<bool> used_;
  Correspondence matches_;
  std::priority_queue<Seed> best_;
  int min_matches_ = 0;
  int visits_ = 0;
};

/// The first of `nodes`, then always the one that is farthest from those before, up to `count`.
std::vector<int> spread(const Proxy& proxy, std::vector<int> nodes, int count) {
  const auto gap = [&](std::size_t chosen, int node) {
    float nearest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < chosen; ++i)
      nearest = std::min(nearest, proxy.node_distance(nodes[i], node));
    return nearest;
  };
  count = std::min(count, static_cast<int>(nodes.size()));
  for (int k = 1; k < count; ++k) {
    const auto next = std::max_element(nodes.begin() + k, nodes.end(),
                                       [&](int a, int b) { return gap(k, a) < gap(k, b); });
    std::rotate(nodes.begin() + k, next, next + 1);
  }
  nodes.resize(count);
  return nodes;
}

}  // namespace

std::vector<int> extremities(const Proxy& proxy, const SeedOptions& options) {
  const std::vector<double> integral = integral_distances(proxy);
  std::vector<int> tips;
  for (int a = 0; a < proxy.num_measured(); ++a) {
    bool farthest = proxy.to_boundary[proxy.nodes[a]] > options.extremity_radius / 2;
    for (int b = 0; farthest && b < proxy.num_measured(); ++b)
      farthest = integral[b] <= integral[a] || proxy.node_distance(a, b) > options.extremity_radius;
    if (farthest) tips.push_back(a);
  }
  std::ranges::stable_sort(tips, std::greater(), [&](int a) { return integral[a]; });
  return spread(proxy, std::move(tips), options.max_extremities);
}

std::vector<Correspondence> seed_matchings(const Proxy& source, const std::vector<int>& source_tips,
                                           const Proxy& target, const std::vector<int>& target_tips,
                                           int fixed, const SeedOptions& options) {
  return SeedSearch(source, source_tips, target, target_tips, options).run(fixed);
}

}  // namespace isomatch::tracked
