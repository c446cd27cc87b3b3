// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "results/group/group_output.h"

namespace isomatch::results {

/// points.npz and modes.npz, see `write_group`.
void write_point_arrays(const std::string& path, const GroupOutput& output);
void write_mode_arrays(const std::string& path, const GroupOutput& output);

}  // namespace isomatch::results
