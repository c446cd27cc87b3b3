// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "results/group/group_output.h"

namespace isomatch::results {

/// points.csv and scores.csv, see `write_group`.
void write_point_table(const std::string& path, const GroupOutput& output);
void write_score_table(const std::string& path, const GroupOutput& output);

}  // namespace isomatch::results
