// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <vector>

#include "isomatch/context.h"
#include "tracked/hypotheses/growth.h"
#include "tracked/hypotheses/poses.h"
#include "tracked/hypotheses/seeds.h"
#include "tracked/options.h"
#include "tracked/shape/proxy.h"

namespace isomatch::tracked {

/// A map between nodes of two proxies.
struct Hypothesis {
  std::vector<int> source_nodes, target_nodes;
  float distortion = 0;
  float orientation = 0;
  /// The motion that it stands for, if it is not a map along the surface.
  std::optional<Pose> pose = std::nullopt;
};

/// Candidates for the map between two shapes, the most plausible first. Reports progress.
std::vector<Hypothesis> find_hypotheses(const Proxy& source, const Proxy& target,
                                        const HypothesisOptions& options, const Context& context);

}  // namespace isomatch::tracked
