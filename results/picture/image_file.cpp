// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "results/picture/bitmap.h"
#include "results/picture/image.h"

namespace isomatch::picture {
namespace {

std::string content_of(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw BadFile(path, error ? error.message() : "is no file");
  std::ifstream file(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw BadFile(path, "cannot be read");
  return content;
}

Bitmap decode(const std::string& path) {
  const std::string content = content_of(path);
  if (content.starts_with("\x89PNG\r\n\x1a\n")) return decode_png(path, content);
  if (content.starts_with("\xff\xd8\xff")) return decode_jpeg(path, content);
  throw BadFile(path, "is neither a PNG nor a JPEG image");
}

/// `linear_intensity` of each byte.
std::array<float, 256> intensities() {
  std::array<float, 256> result{};
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = linear_intensity(static_cast<unsigned char>(i));
  return result;
}

}  // namespace

Image read_image(const std::string& path) {
  const Bitmap bitmap = decode(path);
  const std::array<float, 256> linear = intensities();
  Image image{bitmap.width, bitmap.height, {}};
  const std::size_t pixels = static_cast<std::size_t>(bitmap.width) * bitmap.height;
  image.pixels.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const unsigned char* const pixel = bitmap.bytes.get() + 3 * i;
    image.pixels.emplace_back(linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]);
  }
  return image;
}

}  // namespace isomatch::picture
