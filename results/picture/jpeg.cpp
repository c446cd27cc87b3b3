// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <turbojpeg.h>

#include "results/picture/bitmap.h"

namespace isomatch::picture {
namespace {

/// A block of 64 pixels takes a bit at least.
constexpr std::int64_t kMostJpegPixelsPerByte = 64 * 8;

class Decompressor {
 public:
  Decompressor(const std::string& path, std::string_view file)
      : path_(path), file_(file), handle_(tjInitDecompress(), tjDestroy) {
    if (!handle_) throw InternalError("libjpeg-turbo cannot be initialised");
    int sampling = -1;
    const int status = tjDecompressHeader3(handle_.get(), data(), file_.size(), &width_, &height_,
                                           &sampling, &color_space_);
    // Unusual samplings count as an error there, but do not matter here.
    if (status != 0 && (width_ < 1 || height_ < 1 || color_space_ < 0)) fail();
  }

  Bitmap decode() {
    const bool is_cmyk = color_space_ == TJCS_CMYK || color_space_ == TJCS_YCCK;
    const int channels = is_cmyk ? 4 : 3;
    Bitmap bitmap{width_, height_, nullptr};
    bitmap.bytes = checked_bytes(path_, file_, pixels(), channels, kMostJpegPixelsPerByte);
    // Scans without end would take hours.
    if (tjDecompress2(handle_.get(), data(), file_.size(), bitmap.bytes.get(), width_, 0, height_,
                      is_cmyk ? TJPF_CMYK : TJPF_RGB, TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS) != 0)
      fail();
    if (is_cmyk) convert_from_cmyk(bitmap.bytes.get());
    return bitmap;
  }

 private:
  const unsigned char* data() const { return reinterpret_cast<const unsigned char*>(file_.data()); }

  std::int64_t pixels() const { return static_cast<std::int64_t>(width_) * height_; }

  /// In place. Files have light where ink is not, as Adobe's programs write them.
  void convert_from_cmyk(unsigned char* bytes) const {
    for (std::int64_t i = 0; i < pixels(); ++i)
      for (int k = 0; k < 3; ++k)
        bytes[3 * i + k] = static_cast<unsigned char>(bytes[4 * i + k] * bytes[4 * i + 3] / 255);
  }

  [[noreturn]] void fail() const {
    throw BadFile(path_, fmt::format("is a damaged JPEG image: {}", tjGetErrorStr2(handle_.get())));
  }

  const std::string& path_;
  std::string_view file_;
  std::unique_ptr<void, int (*)(tjhandle)> handle_;
  int width_ = 0, height_ = 0, color_space_ = -1;
};

}  // namespace

Bitmap decode_jpeg(const std::string& path, std::string_view file) {
  return Decompressor(path, file).decode();
}

}  // namespace isomatch::picture
