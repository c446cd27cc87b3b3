// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/correspondence.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/shape/shape.h"
#include "isomatch/stage_times.h"

namespace isomatch {

struct TrackedOptions {
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

/// One of the maps that were tracked. Lengths and energies refer to surfaces of unit area.
struct TrackedMap {
  /// A point on the target for every source vertex that is part of the surface, and the other way
  /// round.
  SurfaceMap source_to_target, target_to_source;
  /// The source's vertices after registration, in the target's coordinates. Vertices that are not
  /// part of the surface follow the nearest one that is.
  std::vector<Point> registered;
  /// As-rigid-as-possible energy of the registration by which maps are ranked, before the last
  /// one; the less, the better.
  double energy = 0;
  /// Mean distance of the nodes of that registration from the target.
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
