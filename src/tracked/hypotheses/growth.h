// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/correspondence.h"
#include "tracked/hypotheses/node_directions.h"
#include "tracked/options.h"

namespace isomatch::tracked {

/// A map between landmarks: for each source landmark a target landmark, `kUnmatched` where none.
struct LandmarkMap {
  std::vector<int> target_of_source;
  /// Mean isometric distortion over all landmarks, of those that are left out their price.
  float distortion = 0;
  /// Mean local orientation in [-1, 1].
  float orientation = 0;
};

/// Extends a partial matching of landmarks to all source landmarks, one by one in their order,
/// and revises maps. One per thread.
class Growth {
 public:
  /// Uses the first `source_count` and `target_count` landmarks.
  Growth(const NodeDirections& source, int source_count, const NodeDirections& target,
         int target_count, const GrowthOptions& options);

  /// `matches` between landmarks.
  LandmarkMap grow(const Correspondence& matches);
  /// The matches and no others.
  LandmarkMap only(const Correspondence& matches) const;
  /// Chooses the target of every landmark again, given all others.
  void revise(LandmarkMap& map);
  /// Fills in distortion and orientation.
  void measure(LandmarkMap& map);

 private:
  void accumulate(int source, const std::vector<int>& map);
  float difference(int source, int other, int target, int other_target) const;
  void find_nearest_matched(int source, const std::vector<int>& map);
  float orientation(int source, int target, const std::vector<int>& map) const;
  int best_target(int source, const std::vector<int>& map);

  const NodeDirections& source_;
  const NodeDirections& target_;
  GrowthOptions options_;
  int source_count_, target_count_;
  bool oriented_, partial_;
  std::vector<std::vector<int>> nearest_;  ///< Source landmarks in order of distance.
  std::vector<float> cost_;
  std::vector<int> near_;
};

}  // namespace isomatch::tracked
