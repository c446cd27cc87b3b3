// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "parallel.h"
#include "steps.h"
#include "tracked/hypotheses/densify.h"
#include "tracked/hypotheses/poses.h"

namespace isomatch::tracked {
namespace {

constexpr const char* kHypothesesStage = "hypotheses";

/// The tips, then evenly spread nodes.
NodeDirections landmarks_of(const Proxy& proxy, const std::vector<int>& tips, int count) {
  std::vector<int> nodes = tips;
  for (int i = 0; i < proxy.num_measured() && static_cast<int>(nodes.size()) < count; ++i)
    if (std::ranges::find(tips, i) == tips.end()) nodes.push_back(i);
  return {proxy, std::move(nodes)};
}

float score(const LandmarkMap& map, const GrowthOptions& options) {
  return map.distortion + options.orientation_weight * (1 - map.orientation) / 2;
}

/// Root mean square, which notices when a single limb goes elsewhere.
float difference(const NodeDirections& target, const LandmarkMap& a, const LandmarkMap& b) {
  constexpr float kLeftOut = 0.2F;  // As far apart as if a limb went elsewhere.
  float sum = 0;
  for (std::size_t i = 0; i < a.target_of_source.size(); ++i) {
    const int s = a.target_of_source[i], t = b.target_of_source[i];
    if (s == kUnmatched && t == kUnmatched) continue;
    const float distance = s == kUnmatched || t == kUnmatched ? kLeftOut : target.distance(s, t);
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<float>(a.target_of_source.size()));
}

/// Drops maps that are mirrored in the main, unless all are.
void drop_mirrored(std::vector<LandmarkMap>& maps) {
  const auto is_mirrored = [](const LandmarkMap& map) { return map.orientation < 0; };
  if (!std::ranges::all_of(maps, is_mirrored)) std::erase_if(maps, is_mirrored);
}

/// Sorts by score, drops maps that are nearly the same as a better one, and keeps the best.
void select(std::vector<LandmarkMap>& maps, const NodeDirections& target, int count,
            const HypothesisOptions& options) {
  std::ranges::stable_sort(maps, {},
                           [&](const LandmarkMap& map) { return score(map, options.growth); });
  std::vector<LandmarkMap> kept;
  for (LandmarkMap& map : maps) {
    const bool known = std::ranges::any_of(kept, [&](const LandmarkMap& other) {
      return difference(target, map, other) < options.same_difference;
    });
    if (!known) kept.push_back(std::move(map));
    if (static_cast<int>(kept.size()) == count) break;
  }
  maps = std::move(kept);
}

Correspondence first_matches(const LandmarkMap& map) {
  Correspondence matches;
  for (std::size_t i = 0; i < map.target_of_source.size(); ++i)
    if (map.target_of_source[i] != kUnmatched)
      matches.push_back({static_cast<int>(i), map.target_of_source[i]});
  return matches;
}

std::vector<LandmarkMap> grow_all(const std::vector<Correspondence>& starts,
                                  const NodeDirections& source, const NodeDirections& target,
                                  const GrowthStage& stage, const HypothesisOptions& options,
                                  const Context& context) {
  std::vector<LandmarkMap> maps(starts.size());
  const auto make = [&] {
    return Growth(source, stage.source_landmarks, target, stage.target_landmarks, options.growth);
  };
  parallel_for(std::ssize(starts), context, make, [&](Growth& growth, std::ptrdiff_t i) {
    maps[i] = growth.grow(starts[i]);
    growth.revise(maps[i]);
    growth.measure(maps[i]);
  });
  std::erase_if(maps, [&](const LandmarkMap& map) {
    return std::ssize(map.target_of_source) - std::ranges::count(map.target_of_source, kUnmatched) <
           std::min<std::ptrdiff_t>(options.seeds.min_matches, std::ssize(map.target_of_source));
  });
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
  for (int i = 0; i < proxy.num_measured() && static_cast<int>(tips.size()) < count; ++i)
    append_new(tips, {i});
}

std::vector<Correspondence> seeds_between(const Proxy& source, const Proxy& target,
                                          const Tips& tips, const SeedOptions& seeds, int fixed) {
  std::vector<Correspondence> starts =
      seed_matchings(source, tips.source, target, tips.target, fixed, seeds);
  for (Correspondence& matches : starts)
    for (Match& match : matches)
      match = {place(tips.source, match.source), place(tips.target, match.target)};
  return starts;
}

std::vector<LandmarkMap> grow_in_stages(const std::vector<Correspondence>& seeds,
                                        const NodeDirections& source, const NodeDirections& target,
                                        const HypothesisOptions& options, const Context& context) {
  std::vector<Correspondence> starts;
  for (const LandmarkMap& map : grow_all(seeds, source, target, options.coarse, options, context))
    starts.push_back(first_matches(map));
  return grow_all(starts, source, target, options.fine, options, context);
}

Hypothesis between_nodes(const LandmarkMap& map, const NodeDirections& source,
                         const NodeDirections& target) {
  Hypothesis hypothesis{{}, {}, map.distortion, map.orientation, std::nullopt};
  for (std::size_t i = 0; i < map.target_of_source.size(); ++i) {
    if (map.target_of_source[i] == kUnmatched) continue;
    hypothesis.source_nodes.push_back(source.node(static_cast<int>(i)));
    hypothesis.target_nodes.push_back(target.node(map.target_of_source[i]));
  }
  return hypothesis;
}

/// A map of the first landmarks of a shape onto each other, extended to all of them.
std::vector<int> extended(const LandmarkMap& map, const NodeDirections& landmarks,
                          const Proxy& proxy) {
  const std::vector<int> images =
      densify(proxy, proxy, between_nodes(map, landmarks, landmarks), proxy.num_nodes());
  std::vector<int> all(landmarks.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<int> targets;
  for (int i = 0; i < landmarks.size(); ++i)
    targets.push_back(*std::ranges::min_element(all, {}, [&](int k) {
      return proxy.node_distance(landmarks.node(k), images[landmarks.node(i)]);
    }));
  return targets;
}

/// How far landmarks are moved on average.
float mean_move(const NodeDirections& landmarks, const std::vector<int>& targets) {
  float sum = 0;
  for (int i = 0; i < landmarks.size(); ++i) sum += landmarks.distance(i, targets[i]);
  return sum / static_cast<float>(landmarks.size());
}

/// Maps of a shape onto itself other than the identity, such as that of left to right, mirrored or
/// not: for each landmark another.
std::vector<std::vector<int>> near_symmetries(const Proxy& proxy, const NodeDirections& landmarks,
                                              std::vector<int> tips,
                                              const HypothesisOptions& options,
                                              const Context& context) {
  HypothesisOptions alone = options;
  alone.growth.fixed = 0;
  tips.resize(std::min(tips.size(), static_cast<std::size_t>(options.seeds.max_extremities)));
  const Tips both{tips, tips};
  std::vector<std::vector<int>> symmetries;
  for (const LandmarkMap& map : grow_all(seeds_between(proxy, proxy, both, options.seeds, 0),
                                         landmarks, landmarks, options.symmetry, alone, context)) {
    std::vector<int> targets = extended(map, landmarks, proxy);
    if (mean_move(landmarks, targets) > options.identity_move)
      symmetries.push_back(std::move(targets));
  }
  return symmetries;
}

/// What the best of the maps become when followed by near-symmetries of the target.
std::vector<LandmarkMap> twins_of(const std::vector<LandmarkMap>& maps,
                                  const std::vector<std::vector<int>>& symmetries,
                                  const NodeDirections& source, const NodeDirections& target,
                                  const HypothesisOptions& options, const Context& context) {
  const std::size_t twinned = std::min(maps.size(), static_cast<std::size_t>(options.max_twinned));
  std::vector<Correspondence> starts;
  for (const std::vector<int>& symmetry : symmetries) {
    for (std::size_t k = 0; k < twinned; ++k) {
      Correspondence twin = first_matches(maps[k]);
      std::erase_if(twin,
                    [&](const Match& m) { return m.source >= options.coarse.source_landmarks; });
      for (Match& match : twin)
        if (match.source >= options.growth.fixed) match.target = symmetry[match.target];
      starts.push_back(std::move(twin));
    }
  }
  return grow_all(starts, source, target, options.fine, options, context);
}

std::vector<Hypothesis> grown_hypotheses(const Proxy& source, const Proxy& target, const Tips& tips,
                                         const SeedOptions& seeds, const HypothesisOptions& options,
                                         const Context& context) {
  const NodeDirections from = landmarks_of(source, tips.source, options.fine.source_landmarks);
  const NodeDirections onto = landmarks_of(target, tips.target, options.fine.target_landmarks);
  // Of the time, how much what is done takes.
  constexpr double kGrown = 0.5, kSymmetric = 0.7;
  std::vector<LandmarkMap> maps = grow_in_stages(
      seeds_between(source, target, tips, seeds, static_cast<int>(options.landmarks.size())), from,
      onto, options, context);
  context.report(kGrown, kHypothesesStage);
  if (!maps.empty()) {
    const auto symmetries = near_symmetries(target, onto, tips.target, options, context);
    context.report(kSymmetric, kHypothesesStage);
    std::ranges::move(twins_of(maps, symmetries, from, onto, options, context),
                      std::back_inserter(maps));
  }
  context.report(1, kHypothesesStage);
  if (options.growth.orientation && source.oriented && target.oriented) drop_mirrored(maps);
  select(maps, onto, options.fine.max_maps, options);
  std::vector<Hypothesis> hypotheses;
  for (const LandmarkMap& map : maps) hypotheses.push_back(between_nodes(map, from, onto));
  return hypotheses;
}

/// What a pose matches, and the given landmarks, which come first in both lists.
Correspondence matches_with_landmarks(const Pose& pose, const Proxy& source,
                                      const NodeDirections& from, const Proxy& target,
                                      const NodeDirections& onto,
                                      const HypothesisOptions& options) {
  const int fixed = options.growth.fixed;
  Correspondence matches = matches_under(pose, source, from, target, onto, options.poses);
  std::erase_if(matches, [&](const Match& m) { return m.source < fixed || m.target < fixed; });
  for (int i = 0; i < fixed; ++i) matches.push_back({i, i});
  return matches;
}

/// Poses themselves, and what grows from what they match.
std::vector<Hypothesis> posed_hypotheses(const Proxy& source, const Proxy& target, const Tips& tips,
                                         const HypothesisOptions& options, const Context& context) {
  const NodeDirections from = landmarks_of(source, tips.source, options.fine.source_landmarks);
  const NodeDirections onto = landmarks_of(target, tips.target, options.fine.target_landmarks);
  GrowthOptions priced = options.growth;
  priced.price = std::min(priced.price, options.poses.landmark_price);
  Growth growth(from, options.fine.source_landmarks, onto, options.fine.target_landmarks, priced);
  std::vector<Hypothesis> hypotheses;
  std::vector<Correspondence> starts;
  for (const Pose& pose : find_poses(source, target, options.poses)) {
    starts.push_back(matches_with_landmarks(pose, source, from, target, onto, options));
    if (std::cmp_less(starts.back().size(), options.seeds.min_matches)) continue;
    LandmarkMap map = growth.only(starts.back());
    growth.measure(map);
    hypotheses.push_back(between_nodes(map, from, onto));
    hypotheses.back().pose = pose;
  }
  for (const LandmarkMap& map : grow_all(starts, from, onto, options.fine, options, context))
    hypotheses.push_back(between_nodes(map, from, onto));
  return hypotheses;
}

}  // namespace

std::vector<Hypothesis> find_hypotheses(const Proxy& source, const Proxy& target,
                                        const HypothesisOptions& options, const Context& context) {
  // Of the time, how much what is done takes.
  constexpr double kFirst = 0.5, kGrown = 0.8;
  Tips tips = sharp_tips(source, target, options);
  std::vector<Hypothesis> hypotheses =
      grown_hypotheses(source, target, tips, options.seeds, options, part_of(context, 0, kFirst));
  const Tips sharp = tips;
  if (std::cmp_less(hypotheses.size(), options.enough)) {
    append_spread_nodes(source, options.seeds.spread_source_nodes, tips.source);
    append_spread_nodes(target, options.seeds.spread_target_nodes, tips.target);
    SeedOptions seeds = options.seeds;
    seeds.min_matches = std::min({seeds.min_matches, source.num_measured(), target.num_measured()});
    std::ranges::move(
        grown_hypotheses(source, target, tips, seeds, options, part_of(context, kFirst, kGrown)),
        std::back_inserter(hypotheses));
  }
  std::ranges::move(posed_hypotheses(source, target, sharp, options, part_of(context, kGrown, 1)),
                    std::back_inserter(hypotheses));
  return hypotheses;
}

}  // namespace isomatch::tracked
