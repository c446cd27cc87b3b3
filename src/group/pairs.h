// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <limits>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "group/places.h"
#include "group/shape_pool.h"
#include "isomatch/context.h"
#include "isomatch/group/group.h"

namespace isomatch::group {

/// Both directions of a pair's map, in the numbers of the surfaces.
struct PairMaps {
  SurfaceMap forward, backward;
  /// See `TrackedMap::cost`.
  double cost = 0;
};

/// A pair that was matched, with the one of its maps that is used.
struct MatchedPair {
  int source = 0, target = 0;
  /// The best first; none if the shapes have too little in common.
  std::vector<PairMaps> maps;
  std::size_t used = 0;
  PairUse use = PairUse::kAgrees;
  /// NaN without maps.
  double cycle_error = 0;

  bool counts() const { return use != PairUse::kComposed; }
  const PairMaps& map() const { return maps[used]; }
  /// NaN without maps.
  double cost() const {
    return maps.empty() ? std::numeric_limits<double>::quiet_NaN() : map().cost;
  }
};

using PairList = std::vector<std::pair<int, int>>;

/// The pairs of a group.
class Pairs {
 public:
  /// Keeps references.
  Pairs(ShapePool& shapes, std::vector<const Surface*> surfaces, const TrackedOptions& options)
      : shapes_(shapes), surfaces_(std::move(surfaces)), options_(options) {}

  /// Matches those that are not matched yet, in either direction, each on one thread.
  void add(PairList pairs, std::string_view stage, const Context& context);
  /// What they say of each other.
  MapGraph graph() const;
  /// Measures how far the cycles through each pair are from closing. Maps that do not close them
  /// give way to a runner-up that does, or else do not count any more. Whether there were such.
  bool weed_out(const std::vector<Places>& places, std::string_view stage, const Context& context);

  /// Whether the median cost of a shape's pairs is far below that of another one's.
  bool fits_far_better(int shape, int other) const;

  const std::vector<MatchedPair>& all() const { return pairs_; }

 private:
  std::vector<MatchedPair> matched(const PairList& pairs, const TrackedOptions& options,
                                   std::string_view stage, const Context& context) const;
  double median_cost(int shape) const;
  double cycle_error(const MapGraph& graph, const std::vector<Places>& places,
                     const MatchedPair& pair, const PairMaps& maps) const;

  ShapePool& shapes_;
  std::vector<const Surface*> surfaces_;
  const TrackedOptions& options_;
  std::set<std::pair<int, int>> known_;
  std::vector<MatchedPair> pairs_;
};

}  // namespace isomatch::group
