// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "isomatch/methods/tracked.h"

namespace isomatch::cli {

/// Adds the options of the tracked method that do not depend on the shapes, in the option group
/// `group`.
void add_tracked_options(CLI::App& command, const std::string& group, TrackedOptions& options);

/// Adds what else of a pair's maps is to be written.
void add_map_options(CLI::App& command, const std::string& group, TrackedOptions& options,
                     bool& target_to_source);

}  // namespace isomatch::cli
