// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/maps/correspondence.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch::results {

/// For each of `targets` the source vertex, of those that `map` matches, whose image is nearest;
/// `kUnmatched` for targets that are not `reached`. O((N + M) log N).
VertexMap nearest_images(const std::vector<Point>& images, const VertexMap& map,
                         const std::vector<Point>& targets, const std::vector<bool>& reached);

}  // namespace isomatch::results
