// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/correspondence.h"
#include "isomatch/merging.h"
#include "isomatch/patch_matching.h"
#include "isomatch/saliency.h"
#include "isomatch/shape.h"

namespace isomatch {

/// How the sampling radii follow from the levels before (Sections 4.1 and 4.3).
struct RadiusOptions {
  /// r(k) = radius_factor sqrt(A(k-1) / pi), A(k-1) the area of the largest patch before.
  double radius_factor = 0.6;
  /// The radii of level 0 grow until neither shape has more base vertices than this. The rule above
  /// gives 12 on animals with thin limbs, where the paper works with 5 to 9.
  int max_coarse_bases = 8;
  /// r(k) is at most this multiple of r(k-1). By the rule alone the radius stays where it is once
  /// the area of a single vertex is that of the largest patch, and the levels never end.
  double max_radius_ratio = 0.7;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

struct PaperOptions {
  SaliencyOptions saliency;
  RadiusOptions radii;
  PatchMatchingOptions patches;
  MergingOptions merging;
  /// Matches in the list that distortion is measured against (E of Section 6).
  int list_size = 100;
  /// Matchings of level 0, the least distorted ones, that are carried on to level
  /// `candidate_levels`, where the least distorted one stays. Between extremities alone, exchanging
  /// the front hooves of a horse changes less than a step does; with the trunk sampled it shows.
  /// 1 is the paper's text.
  int coarse_candidates = 8;
  int candidate_levels = 4;
  /// Levels after level 0; levels also end when every vertex of both shapes is a base vertex.
  int max_levels = 100;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

/// One level k. Base vertices are the first `source_bases` and `target_bases` of the lists in
/// `PaperResult`, and are meant by their place there.
struct PaperLevel {
  /// r_S(k) and r_T(k), in units of the coordinates.
  float source_radius = 0, target_radius = 0;
  int source_bases = 0, target_bases = 0;
  /// xi(k,1): target base of every source base.
  std::vector<int> many_to_one;
  /// xi(k): every base of both shapes occurs.
  Correspondence matches;
  /// D_iso and d_iso-dagger of `many_to_one` and `matches`, against the list of E matches.
  DistortionSummary many_to_one_distortion, distortion;
  int outliers_moved = 0;
};

struct PaperResult {
  /// Base vertices in the order of selection, as vertices of the surfaces; all of them at the last
  /// level if `complete`.
  std::vector<int> source_bases, target_bases;
  std::vector<PaperLevel> levels;
  /// True if every vertex of both surfaces is matched.
  bool complete = false;
};

/// The method of the paper: coarse-to-fine joint sampling, patch-based combinatorial matching and
/// three-step merging, level by level. Departures from the text are named, with their reasons, in
/// `RadiusOptions`, `MatchPatches...` and `merge_matches`. O(N log N).
PaperResult match_paper(const Shape& source, const Shape& target, const PaperOptions& options = {},
                        const Context& context = {});

}  // namespace isomatch
