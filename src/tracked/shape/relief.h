// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <vector>

#include "elastic/projection.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch::tracked {

/// How far each vertex stands out of the surface, at several scales: the distance, along the
/// normal, from the surface after heat flow over scale s, divided by s. Grows with mean curvature,
/// hardly changes as the surface bends at joints. The mesh must have unit area.
std::vector<std::array<double, elastic::kReliefs>> relief(
    const Mesh& mesh, const std::vector<Point>& normals,
    const std::array<double, elastic::kReliefs>& scales);

}  // namespace isomatch::tracked
