// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/mesh/texture.h"
#include "results/picture/image.h"

namespace isomatch::picture {

/// What the faces of a mesh show.
struct TexturePaint {
  Texture texture;
  /// Of each material of the texture; one without pixels stands for a checkerboard.
  std::vector<Image> images;

  /// The colour of `face` at a place in its image, which repeats beyond [0, 1]; interpolated
  /// between pixels. Faces without a material show the checkerboard, those without coordinates
  /// `kUnmatchedColor`.
  Color operator()(int face, const Eigen::Vector2f& place) const;
};

}  // namespace isomatch::picture
