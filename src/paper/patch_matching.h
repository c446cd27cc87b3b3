// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isomatch/maps/correspondence.h"
#include "isomatch/methods/paper.h"

namespace isomatch {

/// One patch pair as numbers. Distances are over the largest geodesic of their shape. M source and
/// M' target base vertices.
struct PatchProblem {
  /// M x M: distances among the source base vertices.
  Eigen::MatrixXf source_distances;
  /// M' x M': distances among the target base vertices.
  Eigen::MatrixXf target_distances;
  /// M x M': sum of |g(s_i, s_l) - g(t_j, t_m)| over the fixed matches (s_l, t_m) of the list xi'.
  Eigen::MatrixXf list_distortion;
};

struct OneToOneMatching {
  /// Sum over the rows of the distortion against the fixed matches and against each other.
  float cost;
  std::vector<int> column_of_row;
};

/// Section 4.1: the `count` one-to-one matchings of all rows into the columns of `problem` (M <=
/// M') with the least isometric distortion (Equation 1 with xi' = xi and the fixed matches), best
/// first. Branch and bound over partial matchings; exact unless `max_search_nodes` is reached, and
/// then still at least one. Throws `InvalidInput` if M > M'.
std::vector<OneToOneMatching> least_distortion_matchings(const PatchProblem& problem, int count,
                                                         const PatchMatchingOptions& options = {});

/// Section 4.1: the `count` least distorted one-to-one matchings of the first `max_patch_bases`
/// rows and columns, best first, each with a residual match for every row or column left over. In
/// row and column indices, every one of which occurs, sorted. Empty if there are no rows or no
/// columns.
std::vector<Correspondence> match_patch(const PatchProblem& problem, int count,
                                        const PatchMatchingOptions& options = {});
/// The best of these, empty if there are no rows or no columns.
Correspondence match_patch(const PatchProblem& problem, const PatchMatchingOptions& options = {});

}  // namespace isomatch
