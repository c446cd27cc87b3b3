// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "results/group/group_output.h"

namespace isomatch::results {

/// Of how many modes there are meshes at most.
inline constexpr int kMostModeMeshes = 5;

std::string shape_mesh_name(const std::string& shape);
/// Of mode `mode`, from zero, below or above the mean by the sign of `side`.
std::string mode_mesh_name(int mode, int side);

/// Meshes of the shapes, of the mean and of modes, see `write_group`.
void write_group_meshes(ResultFolder& folder, const GroupOutput& output);

}  // namespace isomatch::results
