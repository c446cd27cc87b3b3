// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::tracked {

/// A quadratic form in a tangent plane, in coordinates of two directions there.
struct PlaneForm {
  double first = 0, second = 0, mixed = 0;
};

/// A symmetric 3 x 3 tensor: xx, yy, zz, xy, xz, yz.
using SymmetricTensor = Eigen::Vector<float, 6>;

PlaneForm in_plane(const SymmetricTensor& tensor, const Point& first, const Point& second);

inline constexpr int kSecondFormScales = 3;
/// The second fundamental form of a surface at a vertex, as a tensor in space, at several scales.
using SecondForm = std::array<SymmetricTensor, kSecondFormScales>;

/// How a mesh curves at its vertices: what its edges bend by (Cohen-Steiner and Morvan 2003),
/// averaged by heat flow over `length` and over sqrt(2) and 2 times that. Edges of one or of more
/// than two faces do not bend. O(N^1.5).
std::vector<SecondForm> second_forms(const Mesh& mesh, double length);

}  // namespace isomatch::tracked
