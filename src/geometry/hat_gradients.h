// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// Twice the face's area as a vector along its normal, which sees the corners counter-clockwise.
Point area_vector(const std::vector<Point>& positions, const Face& face);

/// For each corner the gradient, times the face's area, of the linear function that is 1 there and
/// 0 at the others. Weighted by the values of a field at the corners and summed over the faces
/// around a vertex they give the direction of its gradient there. Zero on a degenerate face.
std::array<Point, 3> hat_gradients(const Mesh& mesh, const Face& face);

}  // namespace isomatch
