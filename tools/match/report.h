// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "json.h"
#include "match/inputs.h"

namespace isomatch::cli {

/// The fields that every report begins and ends with.
Json report_head(const MatchInputs& inputs, const Json& options);
/// The stages of loading, then those of matching.
std::vector<StageTime> joined(std::vector<StageTime> loading,
                              const std::vector<StageTime>& matching);
Json report_tail(const std::vector<StageTime>& times);

/// Options of every method as they go into the report.
Json options_json(const std::string& method, unsigned long seed);

/// The end of the summary: warnings about the meshes, and where the results are.
void print_closing(const MatchInputs& inputs, const std::string& folder);

}  // namespace isomatch::cli
