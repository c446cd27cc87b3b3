// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "tracked/shape/proxy.h"

namespace isomatch::tracked {

/// Tells how well places on a target agree with known matches: whether they are as close to the
/// target node of each match as a point of the source is to its source node. Closeness, 1 / (g +
/// c), weighs near matches by 1 / (g + c)^2, and does not let two limbs share one as distances do.
class Agreement {
 public:
  /// The places are the first `places` nodes of the target.
  Agreement(const Proxy& source, const Proxy& target, std::span<const int> source_nodes,
            std::span<const int> target_nodes, int places);

  /// Of each place for `node` of the source: sum over the matches of weight times deviation of
  /// closeness. O(places * matches).
  std::vector<float> costs(int node, std::span<const float> weights) const;

 private:
  const Proxy& source_;
  std::span<const int> source_nodes_;
  FloatMatrix near_;
};

}  // namespace isomatch::tracked
