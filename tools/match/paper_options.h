// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/paper.h"

namespace isomatch::cli {

/// Calls `visit(name, value, meaning)` for every option of the paper's method; the one list that
/// flags and reports derive from. Defaults are those of `options`.
template <class Options, class Visitor>
void for_each_paper_option(Options& options, Visitor&& visit) {
  visit("integral-points", options.saliency.integral_points,
        "points that stand for the surface in the integral geodesic distance");
  visit("curvature-scale", options.saliency.curvature_scale,
        "smoothing of the Gaussian curvature, over sqrt(area)");
  visit("radius-factor", options.radii.radius_factor,
        "sampling radius over that of a disk of the largest patch's area");
  visit("max-coarse-bases", options.radii.max_coarse_bases,
        "most base vertices at level 0 (M0 of the paper: 5 to 9)");
  visit("max-radius-ratio", options.radii.max_radius_ratio,
        "largest ratio of the sampling radii of consecutive levels");
  visit("full-share", options.radii.full_share,
        "share of the vertices from which on a level takes all");
  visit("max-patch-bases", options.patches.max_patch_bases,
        "base vertices of a patch in the combinatorial search (cap of M)");
  visit("max-search-nodes", options.patches.max_search_nodes,
        "partial matchings that one combinatorial search looks at");
  visit("outlier-factor", options.merging.outlier_factor,
        "outliers exceed this multiple of the mean distortion");
  visit("candidate-radius", options.merging.candidate_radius,
        "merging looks this far around proposed matches, over the sampling radius");
  visit("relaxation-rounds", options.merging.relaxation_rounds, "repetitions of merging's step 1");
  visit("outlier-rounds", options.merging.outlier_rounds,
        "most repetitions of merging's steps 2 and 3");
  visit("list-size", options.list_size, "matches that distortion is measured against (E)");
  visit("coarse-candidates", options.coarse_candidates, "matchings of level 0 that are carried on");
  visit("candidate-levels", options.candidate_levels,
        "level at which the least distorted candidate stays");
  visit("levels", options.max_levels, "last level K; earlier if every vertex is matched");
}

}  // namespace isomatch::cli
