// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace isomatch::tracked {
namespace {

/// The tips, then evenly spread nodes.
Landmarks landmarks_of(const Proxy& proxy, const std::vector<int>& tips, int count) {
  std::vector<int> nodes = tips;
  for (int i = 0; i < proxy.num_nodes() && static_cast<int>(nodes.size()) < count; ++i)
    if (std::ranges::find(tips, i) == tips.end()) nodes.push_back(i);
  return {proxy, std::move(nodes)};
}

float score(const LandmarkMap& map, const GrowthOptions& options) {
  return map.distortion + options.orientation_weight * (1 - map.orientation) / 2;
}

float mean_distance(const Landmarks& target, const LandmarkMap& a, const LandmarkMap& b) {
  float sum = 0;
  for (std::size_t i = 0; i < a.target_of_source.size(); ++i)
    sum += target.distance(a.target_of_source[i], b.target_of_source[i]);
  return sum / static_cast<float>(a.target_of_source.size());
}

/// Sorts by score, drops maps that are nearly the same as a better one, and keeps the best.
void select(std::vector<LandmarkMap>& maps, const Landmarks& target, int count,
            const HypothesisOptions& options) {
  std::ranges::stable_sort(maps, {},
                           [&](const LandmarkMap& map) { return score(map, options.growth); });
  std::vector<LandmarkMap> kept;
  for (LandmarkMap& map : maps) {
    const bool known = std::ranges::any_of(kept, [&](const LandmarkMap& other) {
      return mean_distance(target, map, other) < options.same_distance;
    });
    if (!known) kept.push_back(std::move(map));
    if (static_cast<int>(kept.size()) == count) break;
  }
  maps = std::move(kept);
}

Correspondence first_matches(const LandmarkMap& map) {
  Correspondence matches;
  for (std::size_t i = 0; i < map.target_of_source.size(); ++i)
    matches.push_back({static_cast<int>(i), map.target_of_source[i]});
  return matches;
}

std::vector<LandmarkMap> grow_all(const std::vector<Correspondence>& starts,
                                  const Landmarks& source, const Landmarks& target,
                                  const GrowthStage& stage, const HypothesisOptions& options,
                                  const Context& context) {
  std::vector<LandmarkMap> maps(starts.size());
#pragma omp parallel num_threads(context.threads)
  {
    Growth growth(source, stage.source_landmarks, target, stage.target_landmarks, options.growth);
#pragma omp for schedule(dynamic)
    for (std::size_t i = 0; i < starts.size(); ++i) {
      maps[i] = growth.grow(starts[i]);
      growth.revise(maps[i]);
      growth.measure(maps[i]);
    }
  }
  select(maps, target, stage.max_maps, options);
  return maps;
}

int place(const std::vector<int>& nodes, int node) {
  return static_cast<int>(std::ranges::find(nodes, node) - nodes.begin());
}

void append_new(std::vector<int>& nodes, const std::vector<int>& more) {
  for (int node : more)
    if (std::ranges::find(nodes, node) == nodes.end()) nodes.push_back(node);
}

/// Nodes of both shapes that seeds match, the given landmarks first.
struct Tips {
  std::vector<int> source, target;
};

Tips sharp_tips(const Proxy& source, const Proxy& target, const HypothesisOptions& options) {
  Tips tips;
  for (const Match& match : options.landmarks) {
    tips.source.push_back(match.source);
    tips.target.push_back(match.target);
  }
  append_new(tips.source, extremities(source, options.seeds));
  append_new(tips.target, extremities(target, options.seeds));
  return tips;
}

void append_spread_nodes(const Proxy& proxy, int count, std::vector<int>& tips) {
  for (int i = 0; i < proxy.num_nodes() && static_cast<int>(tips.size()) < count; ++i)
    append_new(tips, {i});
}

std::vector<Hypothesis> grown_hypotheses(const Proxy& source, const Proxy& target, const Tips& tips,
                                         const SeedOptions& seeds, const HypothesisOptions& options,
                                         const Context& context) {
  std::vector<Correspondence> starts = seed_matchings(
      source, tips.source, target, tips.target, static_cast<int>(options.landmarks.size()), seeds);
  for (Correspondence& matches : starts)
    for (Match& match : matches)
      match = {place(tips.source, match.source), place(tips.target, match.target)};
  const Landmarks from = landmarks_of(source, tips.source, options.fine.source_landmarks);
  const Landmarks onto = landmarks_of(target, tips.target, options.fine.target_landmarks);
  const std::vector<LandmarkMap> coarse =
      grow_all(starts, from, onto, options.coarse, options, context);
  starts.clear();
  for (const LandmarkMap& map : coarse) starts.push_back(first_matches(map));
  std::vector<Hypothesis> hypotheses;
  for (const LandmarkMap& map : grow_all(starts, from, onto, options.fine, options, context)) {
    Hypothesis hypothesis{{}, {}, map.distortion, map.orientation};
    for (int i = 0; i < from.size(); ++i) {
      hypothesis.source_nodes.push_back(from.node(i));
      hypothesis.target_nodes.push_back(onto.node(map.target_of_source[i]));
    }
    hypotheses.push_back(std::move(hypothesis));
  }
  return hypotheses;
}

}  // namespace

std::vector<Hypothesis> find_hypotheses(const Proxy& source, const Proxy& target,
                                        const HypothesisOptions& options, const Context& context) {
  Tips tips = sharp_tips(source, target, options);
  std::vector<Hypothesis> hypotheses =
      grown_hypotheses(source, target, tips, options.seeds, options, context);
  if (std::cmp_greater_equal(hypotheses.size(), options.enough)) return hypotheses;
  append_spread_nodes(source, options.seeds.spread_source_nodes, tips.source);
  append_spread_nodes(target, options.seeds.spread_target_nodes, tips.target);
  SeedOptions seeds = options.seeds;
  seeds.min_matches = std::min({seeds.min_matches, source.num_nodes(), target.num_nodes()});
  std::ranges::move(grown_hypotheses(source, target, tips, seeds, options, context),
                    std::back_inserter(hypotheses));
  return hypotheses;
}

}  // namespace isomatch::tracked
