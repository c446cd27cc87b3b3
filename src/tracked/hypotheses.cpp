// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses.h"

#include <algorithm>
#include <numeric>

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

int place(const std::vector<int>& tips, int node) {
  return static_cast<int>(std::ranges::find(tips, node) - tips.begin());
}

}  // namespace

std::vector<Hypothesis> find_hypotheses(const Proxy& source, const Proxy& target,
                                        const HypothesisOptions& options, const Context& context) {
  const std::vector<int> source_tips = extremities(source, options.seeds);
  const std::vector<int> target_tips = extremities(target, options.seeds);
  std::vector<Correspondence> starts =
      seed_matchings(source, source_tips, target, target_tips, options.seeds);
  for (Correspondence& matches : starts)
    for (Match& match : matches)
      match = {place(source_tips, match.source), place(target_tips, match.target)};
  const Landmarks from = landmarks_of(source, source_tips, options.fine.source_landmarks);
  const Landmarks onto = landmarks_of(target, target_tips, options.fine.target_landmarks);
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

}  // namespace isomatch::tracked
