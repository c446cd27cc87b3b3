// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string_view>

#include "isomatch/mesh/mesh.h"

namespace isomatch::picture {

/// "x", "-x", "y", "-y", "z", "-z" as a unit vector; nothing for anything else.
std::optional<Point> parse_axis(std::string_view name);

/// Which of +y and +z is up in the file, a guess: never the direction in which the shape is
/// thinnest (the sides of an animal, the back of a person); then the one above which the shape
/// would stand; then y. O(N).
Point guess_up(const Mesh& mesh);

/// A view from which most of the shape is seen: upright, from the side that shows the largest area,
/// of two opposite ones that which is nearer to the file's front (+z, or -y if z is up), turned by
/// `turn` degrees about `up` and from slightly above. Rows point right, up and towards the viewer.
/// O(N).
Eigen::Matrix3d choose_view(const Mesh& mesh, const Point& up, double turn = 25);

}  // namespace isomatch::picture
