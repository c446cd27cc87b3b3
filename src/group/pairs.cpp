// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "group/pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "isomatch/error.h"
#include "parallel.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"
#include "steps.h"

namespace isomatch::group {
namespace {

/// Cycles through a right map close better than this, over sqrt(area).
constexpr double kCloses = 0.1;

/// How much a map counts. The variance of maps grows as cost^.8, but what maps of like shapes err
/// in common does not: this power had the least errors (bench/tables/group.py). Below the least
/// cost they differ by the meshing alone.
double weight_of(double cost) {
  constexpr double kLeastCost = 1e-6, kPower = 0.5;
  return std::pow(std::max(cost, kLeastCost), -kPower);
}

MatchedPair match_pair(const Shape& source, const Shape& target, std::pair<int, int> pair,
                       const TrackedOptions& options, const Context& context) {
  MatchedPair result{pair.first, pair.second, {}};
  const Surface& from = *source.prepared().surface();
  const Surface& onto = *target.prepared().surface();
  try {
    for (const TrackedMap& map : match_tracked(source, target, options, context).maps)
      result.maps.push_back({*on_surfaces(from, onto, map.source_to_target),
                             *on_surfaces(onto, from, map.target_to_source), map.cost()});
  } catch (const InvalidInput&) {
    result.use = PairUse::kComposed;
    result.cycle_error = std::numeric_limits<double>::quiet_NaN();
  }
  return result;
}

}  // namespace

std::vector<MatchedPair> Pairs::matched(const PairList& pairs, const TrackedOptions& options,
                                        std::string_view stage, const Context& context) const {
  std::vector<MatchedPair> result(pairs.size());
  const Context alone{.threads = 1, .progress = {}, .stop = context.stop};
  Steps steps(context, stage, 0, 1, static_cast<int>(pairs.size()));
  parallel_for(std::ssize(pairs), context, [&](std::ptrdiff_t k) {
    result[k] = match_pair(shapes_.get(pairs[k].first), shapes_.get(pairs[k].second), pairs[k],
                           options, alone);
    steps.take();
  });
  return result;
}

void Pairs::add(PairList pairs, std::string_view stage, const Context& context) {
  std::erase_if(pairs, [&](const auto& pair) {
    return !known_.insert(std::minmax(pair.first, pair.second)).second;
  });
  std::ranges::move(matched(pairs, options_, stage, context), std::back_inserter(pairs_));
}

MapGraph Pairs::graph() const {
  std::vector<WeightedMap> maps;
  for (const MatchedPair& pair : pairs_) {
    if (!pair.counts()) continue;
    const double weight = weight_of(pair.map().cost);
    maps.push_back({pair.source, pair.target, &pair.map().forward, weight});
    maps.push_back({pair.target, pair.source, &pair.map().backward, weight});
  }
  return {surfaces_, maps};
}

double Pairs::median_cost(int shape) const {
  std::vector<double> costs;
  for (const MatchedPair& pair : pairs_)
    if (pair.source == shape || pair.target == shape)
      costs.push_back(pair.maps.empty() ? std::numeric_limits<double>::infinity() : pair.cost());
  const auto median = costs.begin() + std::ssize(costs) / 2;
  std::ranges::nth_element(costs, median);
  return *median;
}

bool Pairs::fits_far_better(int shape, int other) const {
  // Costs of pairs of one kind differ by less, those of different things by a hundred times.
  constexpr double kFar = 10;
  return kFar * median_cost(shape) < median_cost(other);
}

double Pairs::cycle_error(const MapGraph& graph, const std::vector<Places>& places,
                          const MatchedPair& pair, const PairMaps& maps) const {
  return std::max(graph.disagreement(places, pair.source, pair.target, maps.forward),
                  graph.disagreement(places, pair.target, pair.source, maps.backward));
}

bool Pairs::weed_out(const std::vector<Places>& places, std::string_view stage,
                     const Context& context) {
  constexpr int kRunnersUp = 3;
  const MapGraph maps = graph();
  PairList again;
  std::vector<MatchedPair*> wrong;
  for (MatchedPair& pair : pairs_) {
    if (!pair.counts()) continue;
    pair.cycle_error = cycle_error(maps, places, pair, pair.map());
    if (pair.cycle_error <= kCloses) continue;
    wrong.push_back(&pair);
    again.emplace_back(pair.source, pair.target);
  }
  TrackedOptions more = options_;
  more.alternatives = kRunnersUp;
  std::vector<MatchedPair> found = matched(again, more, stage, context);
  for (std::size_t k = 0; k < wrong.size(); ++k) {
    found[k].use = PairUse::kComposed;
    found[k].cycle_error = wrong[k]->cycle_error;
    for (std::size_t m = 1; m < found[k].maps.size(); ++m) {
      const double error = cycle_error(maps, places, found[k], found[k].maps[m]);
      if (error > kCloses || error >= found[k].cycle_error) continue;
      found[k].use = PairUse::kRunnerUp;
      found[k].cycle_error = error;
      found[k].used = m;
    }
    *wrong[k] = std::move(found[k]);
  }
  return !wrong.empty();
}

}  // namespace isomatch::group
