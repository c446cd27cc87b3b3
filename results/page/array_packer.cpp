// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/array_packer.h"

#include <zlib.h>

#include "isomatch/error.h"

namespace isomatch::results {
namespace {

std::vector<std::uint32_t> deltas(std::span<const std::uint32_t> values) {
  std::vector<std::uint32_t> result;
  result.reserve(values.size());
  std::uint32_t before = 0;
  for (std::uint32_t value : values) {
    result.push_back(zigzag(static_cast<std::int32_t>(value - before)));
    before = value;
  }
  return result;
}

std::string compressed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  const auto* input = reinterpret_cast<const Bytef*>(bytes.data());
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, input, bytes.size(),
                Z_DEFAULT_COMPRESSION) != Z_OK)
    throw InternalError("zlib cannot compress the data of the page");
  result.resize(size);
  return result;
}

}  // namespace

std::uint32_t zigzag(std::int32_t value) {
  return (static_cast<std::uint32_t>(value) << 1) ^ static_cast<std::uint32_t>(value >> 31);
}

void ArrayPacker::add(const std::string& name, std::span<const std::uint32_t> values, int bytes,
                      Layout layout) {
  const bool delta = layout == Layout::kDelta;
  const std::vector<std::uint32_t> differences = delta ? deltas(values) : std::vector<uint32_t>{};
  const std::span<const std::uint32_t> stored = delta ? differences : values;
  // A difference needs one bit more than the values.
  const int planes = delta && bytes < 4 ? bytes + 1 : bytes;
  for (int plane = 0; plane < planes; ++plane)
    for (std::uint32_t value : stored) bytes_.push_back(static_cast<char>(value >> (8 * plane)));
  directory_.push_back({{"name", name},
                        {"count", values.size()},
                        {"bytes", bytes},
                        {"planes", planes},
                        {"delta", delta}});
}

std::string ArrayPacker::pack() const { return base64(compressed(bytes_)); }

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U;
  };
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (int shift = 18; shift >= 0; shift -= 6) text.push_back(kLetters[group >> shift & 63]);
  }
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  text.replace(text.size() - missing, missing, missing, '=');
  return text;
}

}  // namespace isomatch::results
