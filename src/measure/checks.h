// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstddef>

#include "isomatch/maps/correspondence.h"
#include "isomatch/mesh/shape.h"

namespace isomatch {

/// Each throws `InvalidInput` if an index is out of range or the matches are not sorted.
void check_index(int vertex, std::size_t count);
void check_vertex(const Shape& shape, int vertex);
void check_targets(const Shape& target, const Correspondence& matches);
void check_matches(const Shape& source, const Shape& target, const Correspondence& matches);

}  // namespace isomatch
