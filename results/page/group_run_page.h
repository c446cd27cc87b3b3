// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "results/group/group_run.h"

namespace isomatch::results {

inline constexpr const char* kGroupPage = "group.html";

/// The page of a run as HTML: at the points of `output`, which should be all vertices of the
/// template, as surfaces are shown. Throws as `group_page`.
std::string group_run_page(const GroupRun& run, const GroupOutput& output);

/// Writes it into the folder of the run's results as group.html, and adds it to the list of files
/// in their report. Throws `BadFile` too.
void write_group_page(const std::string& folder, const Json& report, const GroupRun& run,
                      const GroupOutput& output);

}  // namespace isomatch::results
