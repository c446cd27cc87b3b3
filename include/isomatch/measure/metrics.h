// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/correspondence.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/shape/shape.h"

/// How good a correspondence is, whatever made it. Matches of vertices that are not part of the
/// shapes' surfaces are left out, and so are template points there; copies of a vertex at a seam
/// count once. All functions are deterministic for any number of threads and throw `InvalidInput`
/// if a vertex is out of range or an option invalid.
namespace isomatch {

/// Template points whose places on both shapes are known: point i lies at vertex `source[i]` and at
/// vertex `target[i]`. A vertex may stand for several points. `kUnmatched` where a shape lacks the
/// point; errors leave it out, `overlap_quality` asks whether a map leaves it out.
struct GroundTruth {
  std::vector<int> source;
  std::vector<int> target;

  int size() const { return static_cast<int>(source.size()); }
};

/// The template points that lie on both surfaces. Throws `InvalidInput` if the lists differ in
/// length.
GroundTruth on_surfaces(const Shape& source, const Shape& target, const GroundTruth& truth);

struct ErrorStatistics {
  /// Number of errors. If there are none, all else is zero.
  int samples = 0;
  double mean = 0;
  double median = 0;
  /// 95th percentile; percentiles interpolate between neighbours in order.
  double p95 = 0;
  double maximum = 0;
  /// All errors, ascending.
  std::vector<double> errors;
};

struct TruthOptions {
  /// Of more errors than this, as many evenly spaced in their order are computed. Errors of a map
  /// that is right cost little, those of a flipped one about half a geodesic field each: the
  /// default keeps meshes of up to 20,000 vertices exact and others within minutes.
  int max_samples = 20000;

  void validate() const;
};

/// Geodesic errors of template points, relative to sqrt(area) of the target's surface: the distance
/// from the true place of each point to every match of its source vertex. Points whose source
/// vertex has no match are left out.
ErrorStatistics template_errors(const Shape& source, const Shape& target, const GroundTruth& truth,
                                const Correspondence& matches, const TruthOptions& options = {},
                                const Context& context = {});

/// Geodesic errors of template points under a map to points on triangles, relative to sqrt(area) of
/// the target's surface. The distance d from the true vertex to a point x of weights w follows from
/// the distances d_i to the corners p_i of its triangle, d^2 = sum w_i d_i^2 - sum w_i |p_i - x|^2,
/// which is exact on flat surfaces; what rounding makes negative is zero. Template points whose
/// source vertex has no point are left out. Throws `InvalidInput` too if the map has not a point,
/// or none, for each vertex of the source.
ErrorStatistics point_errors(const Shape& source, const Shape& target, const GroundTruth& truth,
                             const SurfaceMap& map, const TruthOptions& options = {},
                             const Context& context = {});

/// The mean of the same errors over the template points at each vertex of the source, NaN where
/// there are none or the vertex has no point. All are computed.
std::vector<double> vertex_errors(const Shape& source, const Shape& target,
                                  const GroundTruth& truth, const SurfaceMap& map,
                                  const Context& context = {});
/// Of matches, over these as well.
std::vector<double> vertex_errors(const Shape& source, const Shape& target,
                                  const GroundTruth& truth, const Correspondence& matches,
                                  const Context& context = {});

/// D_grd (`mean`) and d_grd-dagger (`maximum`), equations 5 and 6: the distance from the target of
/// each match to the true place of its source, relative to the target's largest geodesic distance.
/// If a source vertex stands for several template points, its truth is the first of them. Matches
/// whose source vertex stands for none are left out.
ErrorStatistics match_errors(const Shape& source, const Shape& target, const GroundTruth& truth,
                             const Correspondence& matches, const TruthOptions& options = {},
                             const Context& context = {});

struct DistortionOptions {
  /// Length E of the list xi' in equation 2: matches of evenly spread source vertices. If it is at
  /// least the number of matches, the equations are evaluated exactly. A shorter list weighs the
  /// surface by area, where all matches weigh it by vertices: with 500, D_iso of four maps between
  /// meshes of 5,000 vertices was within 5 % of the exact value (.0136 for .0142), with 50 within
  /// 6 %.
  int list_size = 500;

  void validate() const;
};

/// Equations 1, 2 and 4, with distances relative to each surface's own largest one.
struct IsometricDistortion {
  /// Matches between the surfaces: copies of a vertex at a seam count once.
  int matches = 0;
  /// D_iso, the mean over all matches.
  double mean = 0;
  /// d_iso-dagger, the maximum over all matches.
  double maximum = 0;
  /// d_iso of each match, in their order; NaN where a vertex is not part of a surface.
  std::vector<double> per_match;
};

/// Isometric distortion of `matches`. d_iso of a match leaves the match itself out of the list.
/// Cost: two geodesic fields an entry of the list, O(E N log N).
IsometricDistortion isometric_distortion(const Shape& source, const Shape& target,
                                         const Correspondence& matches,
                                         const DistortionOptions& options = {},
                                         const Context& context = {});

/// How much of the target is hit by at least one match.
struct Coverage {
  /// Share of its surface's vertices, in [0, 1].
  double vertices = 0;
  /// Share of its surface's area, each vertex standing for a third of the faces around it.
  double area = 0;
};

Coverage target_coverage(const Shape& source, const Shape& target, const Correspondence& matches);

enum class OrientationVerdict {
  kPreserves,
  kReverses,
  kUndecided,    ///< The landmarks disagree, or too few of them can tell.
  kNotOriented,  ///< A surface is not orientable, or its faces are turned at random.
};

/// "preserves", "reverses", "undecided", "not oriented".
std::string_view to_string(OrientationVerdict verdict);

struct OrientationOptions {
  /// Evenly spaced matches that vote.
  int landmarks = 200;
  /// A landmark looks at landmarks between these distances, relative to sqrt(area).
  double min_distance = 0.05;
  double max_distance = 0.25;

  void validate() const;
};

/// Whether a map turns the surface over, as a left-right flip does.
struct MapOrientation {
  OrientationVerdict verdict = OrientationVerdict::kUndecided;
  /// Share of the landmarks around which the map preserves orientation, in [0, 1].
  double preserved_share = 0;
  /// Mean sign of all triples, weighted by how clear they are, in [-1, 1].
  double mean_sign = 0;
  /// Landmarks that had an opinion.
  int votes = 0;
};

/// Orientation of `matches` by a vote of landmarks. Seen from a landmark, the directions in which
/// shortest paths leave towards two others turn left or right; the map preserves orientation there
/// if the same holds on the target. Faces need not be oriented consistently in the files as long as
/// most are; those of closed surfaces are taken to face outwards. Cost: two geodesic fields a
/// landmark.
MapOrientation map_orientation(const Shape& source, const Shape& target,
                               const Correspondence& matches,
                               const OrientationOptions& options = {}, const Context& context = {});

}  // namespace isomatch
