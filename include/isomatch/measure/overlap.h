// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "isomatch/measure/metrics.h"

/// Whether a map leaves out what has no counterpart, as on partial shapes, and how good it is on
/// the rest. All functions are deterministic for any number of threads and throw `InvalidInput` if
/// lengths do not fit, a vertex or face is out of range, or an option invalid.
namespace isomatch {

/// Where each vertex of the source truly lies on the target: at a vertex, `kUnmatched` where it has
/// no counterpart, or at a point on a triangle, no point likewise. Of copies at a seam the lowest
/// one's counts. A vertex or face that is not part of the target's surface counts as no
/// counterpart, as it does in a map.
using TrueMap = std::variant<VertexMap, SurfaceMap>;

/// How the part of the source that a map matches lies to the part that has a counterpart. The four
/// shares sum to 1, or are all zero if there is nothing to count: no template points.
struct OverlapQuality {
  /// Matched, and has a counterpart.
  double both = 0;
  /// Matched, but has none.
  double only_matched = 0;
  /// Has one, but is unmatched.
  double only_true = 0;
  /// Unmatched, and has none.
  double neither = 0;

  /// Share that the map matches, in [0, 1].
  double matched() const { return both + only_matched; }
  /// Share that has a counterpart, in [0, 1].
  double truly_matched() const { return both + only_true; }

  /// Intersection of the two over their union. Nothing if both are empty.
  std::optional<double> iou() const;
  /// How much of what the map leaves unmatched has no counterpart. Nothing if all is matched.
  std::optional<double> unmatched_precision() const;
  /// How much of what has no counterpart the map leaves unmatched. Nothing if all has one.
  std::optional<double> unmatched_recall() const;
};

/// Shares of the area of the source's surface, each vertex standing for a third of the faces around
/// it. O(N log N).
OverlapQuality overlap_quality(const Shape& source, const Shape& target, const TrueMap& truth,
                               const Correspondence& matches);
OverlapQuality overlap_quality(const Shape& source, const Shape& target, const TrueMap& truth,
                               const SurfaceMap& map);

/// Shares of the template points that lie on the source's surface; those that the target lacks have
/// no counterpart. A point is matched if its source vertex is.
OverlapQuality overlap_quality(const Shape& source, const Shape& target, const GroundTruth& truth,
                               const Correspondence& matches);
OverlapQuality overlap_quality(const Shape& source, const Shape& target, const GroundTruth& truth,
                               const SurfaceMap& map);

/// The same errors in two units.
struct OverlapErrors {
  /// Relative to sqrt(area) of the target's surface.
  ErrorStatistics over_sqrt_area;
  /// Relative to the target's largest geodesic distance.
  ErrorStatistics over_max_geodesic;
};

/// Geodesic errors on the overlap: for each vertex of the source's surface that is matched and has
/// a counterpart, the distance from the true place to each place that it is matched to. All weigh
/// the same. Between two points of one triangle it is the straight line; otherwise the distance
/// from a point to a vertex follows as in `point_errors` from those to the corners of the point's
/// triangle, and between two points that is done at both ends: exact on flat surfaces.
OverlapErrors overlap_errors(const Shape& source, const Shape& target, const TrueMap& truth,
                             const Correspondence& matches, const TruthOptions& options = {},
                             const Context& context = {});
OverlapErrors overlap_errors(const Shape& source, const Shape& target, const TrueMap& truth,
                             const SurfaceMap& map, const TruthOptions& options = {},
                             const Context& context = {});

/// The mean of the same errors at each vertex of the source, over sqrt(area), NaN where it is not
/// in the overlap. All are computed.
std::vector<double> vertex_errors(const Shape& source, const Shape& target, const TrueMap& truth,
                                  const Correspondence& matches, const Context& context = {});
std::vector<double> vertex_errors(const Shape& source, const Shape& target, const TrueMap& truth,
                                  const SurfaceMap& map, const Context& context = {});

}  // namespace isomatch
