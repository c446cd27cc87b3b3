// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/correspondence.h"
#include "tracked/proxy.h"

namespace isomatch::tracked {

struct SeedOptions {
  /// Extremities of a shape, at most.
  int max_extremities = 10;
  /// An extremity is farthest from everything within this distance.
  double extremity_radius = 0.1;
  /// Distances between matched extremities differ by at most this much.
  double max_difference = 0.3;
  /// Difference at which a pair of matches neither speaks for nor against a seed.
  double neutral_difference = 0.09;
  int min_matches = 4;
  int max_seeds = 2000;
  /// Partial matchings that are looked at.
  int max_visits = 2000000;
  /// Evenly spread nodes that complete the tips of shapes that have too few of them for a seed.
  int spread_source_nodes = 6;
  int spread_target_nodes = 60;
};

/// Nodes at the tips of a shape: local maxima of the integral geodesic distance. The first is the
/// greatest, each further one the farthest from those before, so that tips close together, such as
/// those of fingers, do not crowd out other limbs.
std::vector<int> extremities(const Proxy& proxy, const SeedOptions& options);

/// Partial injective matchings between two sets of nodes that roughly keep distances, best first.
/// Branch and bound. Matches are pairs of nodes. The first `fixed` nodes of both sets match.
std::vector<Correspondence> seed_matchings(const Proxy& source, const std::vector<int>& source_tips,
                                           const Proxy& target, const std::vector<int>& target_tips,
                                           int fixed, const SeedOptions& options);

}  // namespace isomatch::tracked
