// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "isomatch/error.h"

/// The decoders behind `read_image`.
namespace isomatch::picture {

/// sRGB bytes, three a pixel, row by row from the top left.
struct Bitmap {
  int width = 0, height = 0;
  std::unique_ptr<unsigned char[]> bytes;
};

/// Room for `pixels` of `channels` bytes each. To be called before a decoder believes what `file`
/// announces: throws `BadFile` with `path` if that is more than `most_per_byte` pixels a byte.
inline std::unique_ptr<unsigned char[]> checked_bytes(const std::string& path,
                                                      std::string_view file, std::int64_t pixels,
                                                      int channels, std::int64_t most_per_byte) {
  if (pixels / most_per_byte > static_cast<std::int64_t>(file.size()))
    throw BadFile(path, "announces more pixels than a file of this size can hold");
  return std::make_unique_for_overwrite<unsigned char[]>(pixels * channels);
}

/// Decode the content of the file `path`, which goes into messages. Throw `BadFile` if it is not
/// sound.
Bitmap decode_png(const std::string& path, std::string_view file);
Bitmap decode_jpeg(const std::string& path, std::string_view file);

}  // namespace isomatch::picture
