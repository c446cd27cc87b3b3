// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/stage_times.h"
#include "shape/metric_surface.h"

namespace isomatch::baselines {

struct GmdsOptions {
  /// Source points of the finest level; the paper compares at about 300.
  int points = 300;
  /// Source points of the coarsest level; each further one has twice as many.
  int coarsest_points = 8;
  /// Evenly spread target vertices that coarsest points may start at.
  int start_candidates = 60;
  /// Partial assignments that are kept while coarsest points are assigned one by one, and complete
  /// ones that are optimised, of which the least stressed one is refined.
  int beam = 2000, starts = 16;
  /// A level ends after this many sweeps, or once a sweep lowers the stress by less than this
  /// share.
  int max_sweeps = 200;
  double tolerance = 1e-4;
  /// Targets of more vertices are refused: all distances between them are kept.
  int max_target_vertices = 20000;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

struct GmdsResult {
  /// Evenly spread source vertices, and where on the target each one lies.
  std::vector<int> source_vertices;
  SurfaceMap points;
  /// Root of the mean squared difference of distances, relative to each shape's largest.
  double stress = 0;
  std::vector<StageTime> times;
};

/// Generalised multidimensional scaling (Bronstein, Bronstein and Kimmel 2006): places source
/// points on the target so that the L2 stress between distances on the source and on the target is
/// least. Points of the target are given by triangle and barycentric coordinates, distances between
/// them interpolated from those between vertices. The stress is quadratic in one point on one
/// triangle; points are moved in turn, across edges where that lowers it, from coarse to fine. The
/// coarsest level begins at the best of several assignments found by beam search. Distances are
/// relative to the largest on each shape. Cannot tell a shape from its mirror image. Throws
/// `InvalidInput` if an option is out of range or the target has too many vertices. O(N^2 log N).
GmdsResult match_gmds(const MetricSurface& source, const MetricSurface& target,
                      const GmdsOptions& options = {}, const Context& context = {});

}  // namespace isomatch::baselines
