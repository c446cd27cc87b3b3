// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/shape/shape.h"

/// Whether a map can be trusted, judged from the map and the two surfaces alone.
namespace isomatch {

enum class FitGrade { kGood, kDoubtful, kPoor };

/// "good", "doubtful", "poor".
std::string_view to_string(FitGrade grade);

/// What a map does to the surfaces. Both are scaled to unit area first.
struct FitMeasures {
  /// Mean over the source of |log s|, s the factor by which a map changes the distances between
  /// points that are near each other.
  double stretch = 0;
  /// Share of the source, in [0, 1], around which |log s| is above log 2 on average: places where
  /// the map is torn, folded or sends a part elsewhere.
  double distorted = 0;
  /// The largest mean change of the distances from one place to all others, over sqrt(area): large
  /// where a limb ends elsewhere, or has no counterpart.
  double displacement = 0;
  /// Correlation, in [-1, 1], of the heights of evenly spread places above the surface around them
  /// with those of their images, which tells front from back where distances do not. 1 where a
  /// surface is too even to tell.
  double relief = 1;
  /// Share of the target that no image is near, and of the source that no vertex with an image is
  /// near.
  double unreached = 0, unmatched = 0;
  /// Share of the source around which it is turned over, or of a mirrored map is not; -1 if a
  /// surface does not tell outside from inside.
  double reversed = 0;
};

struct Fit {
  FitGrade grade = FitGrade::kGood;
  /// Why it is not good, a clause each; the worst first.
  std::vector<std::string> reasons;
  FitMeasures measures;
};

struct FitOptions {
  /// Whether something of the shapes may be missing: then what is not matched or not reached does
  /// not count, nor do distances that lead around what is missing.
  bool parts = false;
  /// How many times as long a unit of the source's is on the target, both being of unit area.
  double scale = 1;
  /// Whether the map is meant to lead from the mirror image of the source, see
  /// `TrackedOptions::allow_reflection`, so that turning the surface over is right.
  bool mirrored = false;
};

/// Judges `source_to_target`, which has a point, or none, for each vertex of the source, whatever
/// made it. A map that is left-right flipped as a whole, has limbs exchanged or leaves a part out
/// is found; one that slides along the surface is not. The limits are calibrated by
/// bench/tables/verdict.py. Deterministic for any number of threads. Throws
/// `InvalidInput` if the map does not fit the surfaces. O(N log N).
Fit judge_fit(const Shape& source, const Shape& target, const SurfaceMap& source_to_target,
              const FitOptions& options = {}, const Context& context = {});
/// Likewise of a map to vertices.
Fit judge_fit(const Shape& source, const Shape& target, const VertexMap& source_to_target,
              const FitOptions& options = {}, const Context& context = {});

}  // namespace isomatch
