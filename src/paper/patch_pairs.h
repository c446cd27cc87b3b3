// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/shape/shape.h"
#include "paper/distortion.h"
#include "paper/merging.h"
#include "paper/patch_matching.h"

namespace isomatch::paper {

/// xi_m(k): the matching of the bases in two corresponding patches of the level before.
struct PatchMatching {
  /// The bases at the centres of the two patches, a pair of xi(k-1).
  Match centres;
  Correspondence matches;
};

/// How one level was matched.
struct MatchedLevel {
  /// In ascending order of their centres. At level 0 a single one, of the whole surfaces.
  std::vector<PatchMatching> patches;
  MergeResult merge;
};

/// Distances that are over the largest geodesic of their shape.
struct NormalizedLevel {
  NormalizedLevel(const ShapeLevel& shape_level, const MetricSurface& shape)
      : level(shape_level), scale(static_cast<float>(1 / shape.max_geodesic())) {}

  float distance(int a, int b) const { return scale * level.neighbourhoods.distance(a, b); }

  const ShapeLevel& level;
  float scale;
};

/// Section 4.1 at level 0: the `count` least distorted matchings of all bases of the one shape with
/// those of the other, best first.
std::vector<Correspondence> match_whole_surfaces(const NormalizedLevel& source,
                                                 const NormalizedLevel& target, int count,
                                                 const PatchMatchingOptions& options);

/// Section 4.1 at levels from 1 on: for every pair of xi(k-1) in `previous` matches the bases of
/// `source` and `target` in the two patches around the pair. The list xi' of a patch pair holds the
/// matchings of its parent patch pairs, which are those of `previous.patches` that contain it, and,
/// to be global enough, the evenly spaced list of `distortion`. Distances beyond the cutoff of the
/// neighbourhoods count as the cutoff.
std::vector<PatchMatching> match_patch_pairs(
    const SampledLevel& coarser, const MatchedLevel& previous, const NormalizedLevel& source,
    const NormalizedLevel& target, const MatchDistortion& distortion,
    const PatchMatchingOptions& options, const Context& context);

}  // namespace isomatch::paper
