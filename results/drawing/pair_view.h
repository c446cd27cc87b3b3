// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "results/folder/result.h"
#include "results/picture/position_colors.h"

namespace isomatch::results {

/// From where both shapes of a result are looked at: rows point right, up and towards the viewer.
struct PairView {
  Eigen::Matrix3d source, target;
};

/// How `choose_view` is to look at the source.
struct ViewOptions {
  /// The file's axis that is up; empty to guess.
  std::string up;
  /// Degrees by which to turn the shapes.
  double turn = 25;
};

/// The view of a mesh alone. Throws `InvalidInput` if an option is out of range.
Eigen::Matrix3d choose_mesh_view(const Mesh& mesh, const ViewOptions& options = {});

/// The source as `choose_view` shows it, and the target turned as the map says, so that matching
/// parts show. Throws `InvalidInput` if an option is out of range.
PairView choose_pair_view(const MatchResult& result, const ResultMap& map,
                          const ViewOptions& options = {});

/// Of each source vertex the colour of the point it is matched to, `kUnmatchedColor` of the others.
std::vector<picture::Color> source_colors(const MatchResult& result, const ResultMap& map,
                                          const picture::PositionColors& color);

/// For each vertex of `target` whether `relation` reaches it.
std::vector<bool> matched_targets(const Mesh& target, const Correspondence& relation);

}  // namespace isomatch::results
