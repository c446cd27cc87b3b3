// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/array_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "io/byte_order.h"
#include "io/npz.h"
#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"

namespace isomatch {
namespace {

using Extents = std::vector<std::int64_t>;

/// Takes the first character of `text`, which is not empty.
char32_t take_character(std::string_view& text) {
  constexpr char32_t kReplacement = 0xfffd;
  const auto first = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  if (first < 0x80) return first;
  const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
  if (first < 0xc2 || first > 0xf4) return kReplacement;
  char32_t character = first & (0x3f >> more);
  for (int i = 0; i < more; ++i) {
    if (text.empty() || (static_cast<unsigned char>(text.front()) & 0xc0) != 0x80)
      return kReplacement;
    character = character << 6 | (static_cast<unsigned char>(text.front()) & 0x3f);
    text.remove_prefix(1);
  }
  constexpr std::array<char32_t, 4> kFirstOfLength = {0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = character >= 0xd800 && character < 0xe000;
  if (character < kFirstOfLength[more] || is_surrogate || character > 0x10ffff) return kReplacement;
  return character;
}

std::u32string characters(std::string_view text) {
  std::u32string result;
  while (!text.empty()) result += take_character(text);
  return result;
}

template <class T>
std::string npy_of(std::string_view type, const Extents& shape, const std::vector<T>& values) {
  std::string bytes = npy_header(type, shape);
  for (const T value : values) append_little_endian(value, bytes);
  return bytes;
}

std::string npy_file(const Extents& shape, const std::vector<double>& values) {
  return npy_of("<f8", shape, values);
}

std::string npy_file(const Extents& shape, const std::vector<std::int32_t>& values) {
  return npy_of("<i4", shape, values);
}

std::string npy_file(const Extents& shape, const std::vector<bool>& values) {
  std::string bytes = npy_header("|b1", shape);
  for (const bool value : values) bytes += value ? '\1' : '\0';
  return bytes;
}

std::string npy_file(const Extents& shape, const std::vector<std::string>& values) {
  std::vector<std::u32string> texts;
  // numpy has no texts of length 0.
  std::size_t length = 1;
  for (const std::string& value : values)
    length = std::max(length, texts.emplace_back(characters(value)).size());
  std::string bytes = npy_header(fmt::format("<U{}", length), shape);
  for (std::u32string& text : texts) {
    text.resize(length);
    for (const char32_t character : text)
      append_little_endian(static_cast<std::uint32_t>(character), bytes);
  }
  return bytes;
}

}  // namespace

void write_arrays(const std::string& path, const std::map<std::string, NumpyArray>& arrays) {
  std::map<std::string, std::string> contents;
  for (const auto& [name, array] : arrays) {
    std::int64_t count = 1;
    for (const std::int64_t extent : array.shape) count *= extent;
    std::visit(
        [&, &shape = array.shape, &content = contents[name]](const auto& values) {
          if (std::ssize(values) != count)
            throw InvalidInput("an array has another number of values than its shape says");
          content = npy_file(shape, values);
        },
        array.values);
  }
  AtomicFile file(path);
  write_npy_files(contents, file);
  file.commit();
}

}  // namespace isomatch
