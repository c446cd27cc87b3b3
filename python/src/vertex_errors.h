// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "prepared.h"
#include "results/evaluation.h"

namespace isomatch::python {

/// How far each of the source's input vertices is mapped from its true place: the geodesic distance
/// over sqrt(area) of the target, the mean if a vertex stands for several template points or has
/// several matches; NaN where there is no truth or no match. Point i of the truth is at these input
/// vertices. All errors are computed. Throws `InvalidInput`.
std::vector<double> vertex_errors(const PreparedMesh& source, const PreparedMesh& target,
                                  const results::MeasuredMap& map, std::span<const int> at_source,
                                  std::span<const int> at_target, const Context& context);

}  // namespace isomatch::python
