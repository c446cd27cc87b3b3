// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "tracked/growth.h"
#include "tracked/proxy.h"
#include "tracked/seeds.h"

namespace isomatch::tracked {

/// A number of landmarks and how different two maps of them are before they count as two.
struct GrowthStage {
  int source_landmarks;
  int target_landmarks;
  int max_maps;
};

struct HypothesisOptions {
  SeedOptions seeds;
  GrowthOptions growth;
  GrowthStage coarse{40, 200, 48};
  GrowthStage fine{100, 400, 16};
  /// Near-symmetries of the target, and hypotheses that they are applied to, at most.
  GrowthStage symmetry{40, 200, 8};
  int max_twinned = 4;
  /// Maps whose landmarks differ by less than this, root mean square, are the same hypothesis.
  float same_difference = 0.07F;
  /// If extremities give fewer hypotheses than this, evenly spread nodes are matched as well: the
  /// right one may be missing where limbs touch, or where there are none.
  int enough = 4;
  /// Nodes that match.
  Correspondence landmarks;
};

/// A map between nodes of two proxies.
struct Hypothesis {
  std::vector<int> source_nodes, target_nodes;
  float distortion = 0;
  float orientation = 0;
};

/// Candidates for the map between two shapes, the most plausible first. Reports progress.
std::vector<Hypothesis> find_hypotheses(const Proxy& source, const Proxy& target,
                                        const HypothesisOptions& options, const Context& context);

}  // namespace isomatch::tracked
