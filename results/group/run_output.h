// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "results/group/group_run.h"

namespace isomatch::results {

/// What a run leaves behind at `vertices` of the template: points, the template's faces between
/// them, statistics. Throws as `shape_model`.
GroupOutput group_output(const GroupRun& run, std::vector<int> vertices,
                         const ShapeModelOptions& options);

/// Options of a run as they go into its report. `template_name` is empty if it is chosen; of
/// `points` see `spread_vertices`.
Json group_options_json(const GroupOptions& group, const std::string& template_name, int points,
                        const ShapeModelOptions& model);

}  // namespace isomatch::results
