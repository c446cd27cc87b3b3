// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/picture/texture_paint.h"

#include <cmath>

#include "results/picture/position_colors.h"

namespace isomatch::picture {
namespace {

/// Eight squares a side, each row and column of its own hue, so that a place can be told.
Color checkerboard(const Eigen::Vector2f& place) {
  constexpr float kSquares = 8;
  const float x = place.x() - std::floor(place.x()), y = place.y() - std::floor(place.y());
  const int column = static_cast<int>(kSquares * x), row = static_cast<int>(kSquares * y);
  const Color color(0.1F + 0.8F * x, 0.25F + 0.4F * (1 - x) * y, 0.1F + 0.8F * y);
  return (column + row) % 2 == 0 ? color : Color(0.5F * color + Color::Constant(0.5F));
}

int wrapped(int index, int count) { return ((index % count) + count) % count; }

Color interpolated(const Image& image, const Eigen::Vector2f& place) {
  // Pixels are samples at their centres; rows run from the top.
  const float x = place.x() * static_cast<float>(image.width) - 0.5F;
  const float y = (1 - place.y()) * static_cast<float>(image.height) - 0.5F;
  const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
  const float right_share = x - std::floor(x), lower_share = y - std::floor(y);
  const auto pixel = [&](int column, int row) {
    return image.at(wrapped(column, image.width), wrapped(row, image.height));
  };
  const Color upper = (1 - right_share) * pixel(left, top) + right_share * pixel(left + 1, top);
  const Color lower =
      (1 - right_share) * pixel(left, top + 1) + right_share * pixel(left + 1, top + 1);
  return (1 - lower_share) * upper + lower_share * lower;
}

}  // namespace

Color TexturePaint::operator()(int face, const Eigen::Vector2f& place) const {
  if (!texture.covers(face)) return kUnmatchedColor;
  const int material = texture.face_material[face];
  if (material == Texture::kNone || images[material].pixels.empty()) return checkerboard(place);
  return interpolated(images[material], place);
}

}  // namespace isomatch::picture
