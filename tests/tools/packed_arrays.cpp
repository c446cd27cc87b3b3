// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tools/packed_arrays.h"

#include <gtest/gtest.h>
#include <zlib.h>

namespace isomatch::results {
namespace {

std::int32_t unzigzag(std::uint32_t value) {
  return static_cast<std::int32_t>((value >> 1) ^ (0U - (value & 1U)));
}

std::vector<std::uint32_t> from_planes(std::string_view bytes, std::size_t count, int planes) {
  std::vector<std::uint32_t> values(count);
  for (int plane = 0; plane < planes; ++plane)
    for (std::size_t i = 0; i < count; ++i)
      values[i] |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[plane * count + i]))
                   << (8 * plane);
  return values;
}

}  // namespace

std::string from_base64(std::string_view text) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(kLetters.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<char>(bits >> count));
  }
  return bytes;
}

std::string inflated(const std::string& packed) {
  const std::string deflated = from_base64(packed);
  std::string bytes(1 << 24, '\0');
  uLongf size = bytes.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                       reinterpret_cast<const Bytef*>(deflated.data()), deflated.size()),
            Z_OK);
  bytes.resize(size);
  return bytes;
}

std::vector<std::uint32_t> unpacked(const PageData& page, const std::string& name) {
  const std::string bytes = inflated(page.arrays);
  std::size_t start = 0;
  for (const Json& entry : page.manifest.at("arrays")) {
    const std::size_t count = entry.at("count");
    const int planes = entry.at("planes");
    if (entry.at("name") == name) {
      std::vector<std::uint32_t> values =
          from_planes(std::string_view(bytes).substr(start), count, planes);
      std::uint32_t sum = 0;
      if (entry.at("delta"))
        for (std::uint32_t& value : values)
          value = sum += static_cast<std::uint32_t>(unzigzag(value));
      return values;
    }
    start += count * planes;
  }
  ADD_FAILURE() << "no array " << name;
  return {};
}

}  // namespace isomatch::results
