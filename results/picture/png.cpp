// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>

#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "results/picture/bitmap.h"
#include "results/picture/image.h"

namespace isomatch::picture {
namespace {

/// Of one bit each, where deflate makes a thousandth of them.
constexpr std::int64_t kMostPngPixelsPerByte = 8 * 1032;

std::vector<unsigned char> srgb_bytes(const Image& image) {
  std::vector<unsigned char> bytes;
  bytes.reserve(image.pixels.size() * 3);
  for (const Color& pixel : image.pixels)
    for (float channel : pixel) bytes.push_back(srgb_byte(channel));
  return bytes;
}

/// The file's content.
std::string encode(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  const std::vector<unsigned char> bytes = srgb_bytes(image);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string file(size, '\0');
  if (png_image_write_to_memory(&png, file.data(), &size, 0, bytes.data(), 0, nullptr) == 0)
    throw InternalError(fmt::format("libpng: {}", png.message));
  file.resize(size);
  return file;
}

}  // namespace

unsigned char srgb_byte(float linear) {
  const float x = std::clamp(linear, 0.0F, 1.0F);
  const float encoded = x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
  return static_cast<unsigned char>(std::lround(255 * encoded));
}

float linear_intensity(unsigned char srgb) {
  const float x = static_cast<float>(srgb) / 255;
  return x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F);
}

Bitmap decode_png(const std::string& path, std::string_view file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_imagep)> owner(&png, png_image_free);
  const auto fail = [&] {
    throw BadFile(path, fmt::format("is a damaged PNG image: {}", png.message));
  };
  if (png_image_begin_read_from_memory(&png, file.data(), file.size()) == 0) fail();
  png.format = PNG_FORMAT_RGB;
  Bitmap bitmap{static_cast<int>(png.width), static_cast<int>(png.height), nullptr};
  const std::int64_t pixels = static_cast<std::int64_t>(png.width) * png.height;
  bitmap.bytes = checked_bytes(path, file, pixels, 3, kMostPngPixelsPerByte);
  const png_color background{255, 255, 255};
  if (png_image_finish_read(&png, &background, bitmap.bytes.get(), 0, nullptr) == 0) fail();
  return bitmap;
}

void write_png(const std::string& path, const Image& image) {
  AtomicFile file(path);
  file.write(encode(image));
  file.commit();
}

}  // namespace isomatch::picture
