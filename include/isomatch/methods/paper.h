// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/correspondence.h"
#include "isomatch/methods/sampling.h"
#include "isomatch/shape/shape.h"
#include "isomatch/stage_times.h"

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
  /// A shape of whose vertices this share are bases takes all the others at the next level (radius
  /// 0). On meshes with a few short edges the radii would need ten more levels to separate the last
  /// vertices, at the full cost of each.
  double full_share = 0.9;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

struct PatchMatchingOptions {
  /// Base vertices of a patch that take part in the combinatorial search; further ones get residual
  /// matches. The paper expects M <= 6, but 7 to 9 do occur at most levels.
  int max_patch_bases = 8;
  /// Partial matchings that a search looks at before it settles for the best one found. Reached
  /// only where many base vertices are alike.
  int max_search_nodes = 100000;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

struct MergingOptions {
  /// A match is an outlier if its d_iso exceeds this multiple of the mean (step 3).
  double outlier_factor = 2;
  /// Steps 1 and 2 choose not only among the matches that the patches propose, but among all base
  /// vertices within this multiple of the sampling radius of a proposed one. 0 is the paper's
  /// text.
  double candidate_radius = 2;
  /// How often step 1 is repeated, each time around the matches found before and against a list of
  /// these. 1 is the paper's text.
  int relaxation_rounds = 2;
  /// How often step 3 (with step 2) is repeated at most; it ends early when no outlier moves.
  int outlier_rounds = 4;

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
  int coarse_candidates = 24;
  int candidate_levels = 4;
  /// Of those candidates the least distorted one stays that does not turn the surface over, if
  /// there is one: the text leaves open which of left and right is which, as distances do. Off by
  /// default, since it is not the paper's.
  bool keep_orientation = false;
  /// The last level K; levels also end when every vertex of both shapes is a base vertex.
  int max_levels = 100;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

/// One level k. Base vertices are the first `source_bases` and `target_bases` of the lists in
/// `PaperResult`, and are meant by their place there.
struct PaperLevel {
  /// r_S(k) and r_T(k), in units of the coordinates.
  double source_radius = 0, target_radius = 0;
  int source_bases = 0, target_bases = 0;
  /// xi(k,1): target base of every source base, and d_iso of each.
  std::vector<int> many_to_one;
  std::vector<double> many_to_one_distortion;
  /// xi(k): every base of both shapes occurs. d_iso of each match.
  Correspondence matches;
  std::vector<double> distortion;
  /// Outliers that step 3 of the merging moved.
  int outliers_moved = 0;
};

struct PaperResult {
  /// Base vertices in the order of selection.
  std::vector<int> source_bases, target_bases;
  /// At least level 0. d_iso refers to distances over the largest geodesic and to the list of E
  /// matches of each level.
  std::vector<PaperLevel> levels;
  /// Target vertex of every source vertex: the matches of the last level without those that were
  /// added for isolated targets. Copies at a seam have the same. `kUnmatched` for vertices that are
  /// no bases.
  VertexMap source_to_target;
  /// True if every vertex of both surfaces is matched.
  bool complete = false;
  std::vector<StageTime> times;
};

/// D_iso and d_iso-dagger: mean and maximum of d_iso over the matches of a correspondence
/// (Equations 1 and 4).
struct DistortionSummary {
  double mean = 0;
  double max = 0;
};

/// Both of them zero if there are no matches.
DistortionSummary summarize(std::span<const double> d_iso);

/// The base vertices of both shapes at one level, in the order of selection.
struct JointSampling {
  std::vector<int> source, target;
};

/// The base vertices of `level`, from 0, or of the level at which all vertices are bases if that
/// comes first: those that `match_paper` matches. Throws `InvalidInput` if `level` is negative or
/// an option out of range.
JointSampling sample_jointly(const Shape& source, const Shape& target, int level,
                             const PaperOptions& options = {}, const Context& context = {});

/// The method of the paper: coarse-to-fine joint sampling, patch-based combinatorial matching and
/// three-step merging, level by level. Departures from the text stand, with their reasons, at
/// `RadiusOptions`, `PaperOptions::coarse_candidates`, `PatchMatchingOptions` and `MergingOptions`.
/// O(N log N). Deterministic for any number of threads. Throws `InvalidInput` if an option is out
/// of range, `Cancelled` if `context` says so.
PaperResult match_paper(const Shape& source, const Shape& target, const PaperOptions& options = {},
                        const Context& context = {});

}  // namespace isomatch
