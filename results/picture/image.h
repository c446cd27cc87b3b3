// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace isomatch::picture {

/// Linear red, green and blue in [0, 1] (sRGB primaries).
using Color = Eigen::Vector3f;

/// Pixels row by row from the top left.
struct Image {
  int width = 0, height = 0;
  std::vector<Color> pixels;

  const Color& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// The sRGB byte of a linear intensity, which is clamped to [0, 1] first.
unsigned char srgb_byte(float linear);

/// The linear intensity of an sRGB byte.
float linear_intensity(unsigned char srgb);

/// Reads a PNG or JPEG image of any kind, which its content tells, not its name. What is
/// transparent is white behind; CMYK is taken as Adobe writes it, without profile. Throws `BadFile`
/// if it is missing, of another kind, or not sound. Memory stays within what a sound file of its
/// size can need.
Image read_image(const std::string& path);

/// Writes `image` as an sRGB PNG of 8 bits a channel. The file appears whole or not at all. Throws
/// `BadFile` if it cannot be written.
void write_png(const std::string& path, const Image& image);

}  // namespace isomatch::picture
