// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "results/group/group_output.h"

namespace isomatch::results {

std::string particles_name(const std::string& shape);
std::string landmarks_name(const std::string& shape);

/// The points of each shape for ShapeWorks and 3D Slicer, see `write_group`.
void write_single_shapes(ResultFolder& folder, const GroupOutput& output);

}  // namespace isomatch::results
