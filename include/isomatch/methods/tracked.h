// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/correspondence.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/shape/shape.h"
#include "isomatch/stage_times.h"

namespace isomatch {

struct TrackedOptions {
  /// Nothing of the shapes is missing. Otherwise a shape whose boundary is long (half of sqrt(area)
  /// and more) is taken for a part: what is beyond its boundary may be on the other shape, and what
  /// has no counterpart gets none.
  bool whole = false;
  /// What makes the sizes of the shapes alike: "same", that both are in the same units; "area",
  /// that both have the same area; "auto": the latter where nothing is missing; otherwise the
  /// former, unless they then differ by more than four times.
  std::string scale = "auto";
  /// Try to match the mirror image of the source as well.
  bool allow_reflection = false;
  /// Let orientation guide the growth of hypotheses.
  bool orientation = true;
  /// Choose among hypotheses by elastic energy; without, by distortion and orientation alone.
  bool elastic_judging = true;
  /// Refine by alternating spectral and elastic steps after a first registration.
  bool refinement = true;
  /// Maps besides the best one that are refined and returned, if there are as many.
  int alternatives = 0;
  /// Pairs of vertices that must match. No source vertex twice.
  Correspondence landmarks;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

/// One of the maps that were tracked. Lengths and energies are in the unit of the pair: sqrt(area),
/// of parts that of the larger one, see `PairView`.
struct TrackedMap {
  /// A point on the target for every source vertex that has a counterpart, and the other way round.
  /// Where nothing is missing these are all that are part of the surface.
  SurfaceMap source_to_target, target_to_source;
  /// How sure the point of each source and of each target vertex is, in [0, 1], 0 where there is
  /// none and for vertices that are not part of the surface: of those with .9 nine in ten are
  /// within .05 of the truth, in the unit of the pair (bench/tables/partial.py has a table). What
  /// has a near twin may be sure and wrong all the same, see `TrackedResult::ambiguity`.
  std::vector<float> source_confidence, target_confidence;
  /// The source's vertices after registration, in the target's coordinates, those without a
  /// counterpart as what is around them moves. Where the surface was folded it is smoothed, which
  /// moves some vertices off the points that the map has for them. Vertices that are not part of
  /// the surface follow the nearest ones that are.
  std::vector<Point> registered;
  /// As-rigid-as-possible energy of the registration by which maps are ranked, before the last
  /// one; the less, the better. Of parts with the price of what is left out.
  double energy = 0;
  /// Mean distance of the nodes of that registration from the target, and mean distance from them
  /// of what they leave uncovered of it; of parts instead the price of what is left out.
  double distance = 0;
  /// Mean deviation of their normals from the target's, 1 - cosine.
  double deviation = 0;
  /// Mean isometric distortion, and the local orientation in [-1, 1] of the hypothesis it began as.
  double distortion = 0, orientation = 0;
  /// Whether it maps the mirror image of the source, see `TrackedOptions::allow_reflection`.
  bool mirrored = false;

  /// How badly the shapes fit under it, by which the finalists are ranked.
  double cost() const { return energy * distance; }
};

/// What the shapes of a pair were taken for.
struct PairView {
  /// Whether something may be missing beyond the boundary of each.
  bool source_is_part = false, target_is_part = false;
  /// "same" or "area", see `TrackedOptions::scale`.
  std::string scale = "area";
  /// The unit of length of a pair, in units of the source's and of the target's mesh.
  double source_unit = 1, target_unit = 1;
  /// Whether parts that touch were taken apart, such as a hand that was fused to a hip.
  bool source_is_cut = false, target_is_cut = false;
};

/// What became of a hypothesis.
struct HypothesisSummary {
  double distortion = 0, orientation = 0;
  /// Elastic energy of a quick, coarse registration, by which hypotheses are ranked.
  double coarse_energy = 0;
};

struct TrackedResult {
  /// The best map, then the alternatives.
  std::vector<TrackedMap> maps;
  /// All hypotheses that were judged, best first.
  std::vector<HypothesisSummary> hypotheses;
  /// C1 / C2 in [0, 1], C the energy times the distance (see `TrackedMap`) of the best map and of
  /// the best other one: near 1 where the choice is ambiguous. Half way through refinement if no
  /// other map was followed farther. 0 if there was no other. It does not tell whether the best map
  /// is right; see `judge_fit`.
  double ambiguity = 0;
  /// Those of the landmarks that a map which fits far better does not satisfy. They are kept all
  /// the same, in every map.
  Correspondence contradicted_landmarks;
  PairView taken_for;
  /// Whether both surfaces tell outside from inside, so that mirrored maps could be excluded.
  bool oriented = false;
  std::vector<StageTime> times;
};

/// Throws the `InvalidInput` that `match_tracked` would throw because of landmarks: if one is out
/// of range or not part of the surface, a source vertex has two, or copies at a seam have different
/// ones.
void check_landmarks(const Shape& source, const Shape& target, const Correspondence& landmarks);

/// The tracked method: hypotheses from partial matchings of extremities, grown landmark by landmark
/// under isometric distortion and orientation, with twins by the target's near-symmetries; ranked
/// by a coarse elastic registration; the best refined by alternating spectral maps (Melzi et al.
/// 2019) and as-rigid-as-possible registration (Sorkine and Alexa 2007); of these, the one that
/// fits best refined further and carried over to all vertices. Deterministic for any number of
/// threads. Throws `InvalidInput` if an option is out of range, as `check_landmarks`, or if no
/// hypothesis is found, `Cancelled` if `context` says so. O(N log N).
TrackedResult match_tracked(const Shape& source, const Shape& target,
                            const TrackedOptions& options = {}, const Context& context = {});

/// A many-to-many relation in which every vertex of both surfaces occurs, with all its copies at
/// seams: `source_to_target` at its nearest vertices, and the nearest source of each target vertex
/// that it does not hit.
Correspondence matches(const Shape& source, const Shape& target, const TrackedMap& map);

}  // namespace isomatch
