// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/shape/shape.h"
#include "results/batch/pair_list.h"
#include "results/evaluation.h"

/// Truth that is known of the shapes of a batch: a folder with NAME.vts for each shape NAME.off,
/// whose line i is the vertex of template point i, see `read_ground_truth`.
namespace isomatch::results {

/// The files of a pair. Empty if `folder` is.
TruthFiles truth_files(const std::string& folder, const ListedPair& pair);

/// Throws `BadFile` if the folder lacks a file for a shape of these pairs.
void check_truth(const std::string& folder, const std::vector<ListedPair>& pairs);

/// The mean error of the template points, as `isomatch eval` has it of points on triangles. None
/// where there is no truth or no point to measure.
std::optional<double> mean_point_error(const Shape& source, const Shape& target,
                                       const TruthVertices& truth, const SurfaceMap& map,
                                       const Context& context);

}  // namespace isomatch::results
