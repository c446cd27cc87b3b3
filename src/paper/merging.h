// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/correspondence.h"
#include "isomatch/methods/paper.h"
#include "paper/distortion.h"
#include "paper/sampling.h"

namespace isomatch {

/// A relation that covers all bases of both shapes.
struct BaseMatching {
  /// Target base of every source base.
  std::vector<int> target_of_source;
  /// Source base of every target base that is not in the image of `target_of_source`, else
  /// `kUnmatched`.
  std::vector<int> source_of_isolated;

  /// All matches, sorted, without repetition.
  Correspondence matches() const;
};

struct MergeResult {
  /// xi(k,1) after step 1: target base of every source base.
  std::vector<int> many_to_one;
  /// xi(k) after step 3.
  BaseMatching merged;
  /// Outliers that step 3 moved.
  int outliers_moved = 0;
  /// d_iso of `many_to_one` and of `merged.matches()`, match by match, against the final list.
  std::vector<double> many_to_one_distortion, distortion;
};

/// Section 4.2: merges the union of the patch matchings (`proposals`, xi(k,0), in which every base
/// of both shapes occurs) into one relation in three steps.
///
/// Departures from the text, each measured on the horse gallop (mean of ten pairs at level 4):
/// - the list xi' is drawn from the `inherited` matches, for which the previous level found an
///   accurate place, instead of from the proposals, of which many are wrong;
/// - `candidate_radius` and `relaxation_rounds`: the proposals of one patch pair hold only one
///   partner for each base, and an error of the previous level leaves the right one out;
/// - step 2 chooses among the sources whose matches lie within `candidate_radius` as well;
/// - step 3 looks for the least distortion by descent from the best of the coarser target bases,
///   not over all of T(k), which would make the cost quadratic; an outlier that step 2 assigned to
///   an isolated target base gets another source, since another target would isolate it again.
///
/// `inherited` is `target_of_source` of the level before, of the bases that it had; at level 0 it
/// is empty, and the proposals make the list. Deterministic. O(|S(k)| E).
MergeResult merge_matches(const SampledLevel& level, const Correspondence& proposals,
                          std::span<const int> inherited, FieldStore& source_fields,
                          FieldStore& target_fields, const MergingOptions& options = {},
                          const Context& context = {});

}  // namespace isomatch
