// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <variant>

#include "results/picture/canvas.h"

namespace isomatch::picture {

/// A mesh as it is to be seen: a colour for every vertex or a texture, and rows that point right,
/// up and towards the viewer.
struct Portrait {
  const Mesh& mesh;
  std::variant<std::vector<Color>, TexturePaint> look;
  Eigen::Matrix3d rotation;
};

/// Two meshes side by side, each drawn as if its surface had the same area, in a picture `width`
/// pixels wide and as high as it takes, at most as high as wide.
Image draw_pair(const Portrait& left, const Portrait& right, int width, const Color& background);

}  // namespace isomatch::picture
