// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "results/folder/inputs.h"
#include "results/json.h"

namespace isomatch::results {

/// The fields that every report begins and ends with.
Json report_head(const MatchInputs& inputs, const Json& options);
/// The stages of loading, then those of matching.
std::vector<StageTime> joined(std::vector<StageTime> loading,
                              const std::vector<StageTime>& matching);
Json report_tail(const std::vector<StageTime>& times);

/// Options of every method as they go into the report.
Json options_json(const std::string& method);

}  // namespace isomatch::results
