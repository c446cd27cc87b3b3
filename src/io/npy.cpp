// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <utility>

#include "io/byte_order.h"
#include "io/npz.h"

namespace isomatch {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";

/// What the header of an .npy file says, in the spelling of Python.
struct NpyHeader {
  std::string_view type;
  bool fortran_order;
  std::vector<std::int64_t> shape;
};

template <class T>
double number(const char* bytes, std::endian order) {
  return static_cast<double>(load<T>(bytes, order));
}

struct NumberType {
  std::string_view name;
  std::size_t size;
  double (*number)(const char*, std::endian);
};

constexpr std::array<NumberType, 10> kTypes = {{{"i1", 1, number<std::int8_t>},
                                                {"u1", 1, number<std::uint8_t>},
                                                {"i2", 2, number<std::int16_t>},
                                                {"u2", 2, number<std::uint16_t>},
                                                {"i4", 4, number<std::int32_t>},
                                                {"u4", 4, number<std::uint32_t>},
                                                {"i8", 8, number<std::int64_t>},
                                                {"u8", 8, number<std::uint64_t>},
                                                {"f4", 4, number<float>},
                                                {"f8", 8, number<double>}}};

class NpyParser {
 public:
  NpyParser(const InputFile& file, const std::string& name, std::string_view content)
      : file_(file), name_(name), content_(content) {}

  std::optional<NpyArray> parse() {
    const NpyHeader header = take_header();
    const auto type = std::ranges::find(kTypes, header.type.substr(1), &NumberType::name);
    if (type == kTypes.end()) return std::nullopt;
    const std::size_t count = content_.size() / type->size;
    check_count(header, count, type->size);
    NpyArray array{header.shape, std::vector<double>(count), header.type[1] != 'f'};
    const std::endian order = header.type[0] == '>' ? std::endian::big : std::endian::little;
    for (std::size_t i = 0; i < count; ++i)
      array.values[place(header, i, count)] = type->number(&content_[i * type->size], order);
    return array;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    file_.fail(fmt::format("array {}: {}", in_quotes(name_), reason));
  }

  /// Leaves the array's data in `content_`.
  NpyHeader take_header() {
    if (!content_.starts_with(kMagic) || content_.size() < 12) fail("is not one of numpy");
    const int version = content_[6];
    const std::size_t prefix = version == 1 ? 10 : 12;
    std::size_t length = 0;
    for (std::size_t i = prefix; i-- > 8;)
      length = length << 8 | static_cast<unsigned char>(content_[i]);
    if (version < 1 || version > 3 || length > content_.size() - prefix) fail("malformed header");
    const std::string_view text = content_.substr(prefix, length);
    content_.remove_prefix(prefix + length);
    const std::string_view type = quoted(after(text, "'descr':"));
    const std::string_view order = after(text, "'fortran_order':");
    if (type.size() < 2) fail("malformed header");
    return {type, order.starts_with("True"), numbers(after(text, "'shape':"))};
  }

  std::string_view after(std::string_view text, std::string_view key) const {
    const std::size_t at = text.find(key);
    if (at == std::string_view::npos) fail(fmt::format("its header has no {}", key));
    text.remove_prefix(at + key.size());
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    return text;
  }

  /// Records have a list here, and no type that this program knows.
  static std::string_view quoted(std::string_view text) {
    if (!text.starts_with('\'')) return "|none";
    text.remove_prefix(1);
    return text.substr(0, text.find('\''));
  }

  std::vector<std::int64_t> numbers(std::string_view text) const {
    const std::size_t end = text.find(')');
    if (!text.starts_with('(') || end == std::string_view::npos) fail("malformed shape");
    text = text.substr(1, end - 1);
    std::vector<std::int64_t> result;
    while (true) {
      text.remove_prefix(std::min(text.find_first_not_of(", "), text.size()));
      if (text.empty()) return result;
      std::int64_t number = 0;
      const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), number);
      if (error != std::errc() || number < 0) fail("malformed shape");
      text.remove_prefix(last - text.data());
      result.push_back(number);
    }
  }

  void check_count(const NpyHeader& header, std::size_t count, std::size_t size) const {
    double announced = 1;
    for (const std::int64_t extent : header.shape) announced *= static_cast<double>(extent);
    if (announced != static_cast<double>(count) || content_.size() % size != 0)
      fail(fmt::format("its shape ({}) does not fit its {} bytes", fmt::join(header.shape, ", "),
                       content_.size()));
  }

  /// Where element `i` of the file belongs.
  static std::size_t place(const NpyHeader& header, std::size_t i, std::size_t count) {
    if (!header.fortran_order || header.shape.empty()) return i;
    std::size_t result = 0, step = count;
    for (const std::int64_t extent : header.shape) {
      step /= extent;
      result += i % extent * step;
      i /= extent;
    }
    return result;
  }

  const InputFile& file_;
  const std::string& name_;
  std::string_view content_;
};

}  // namespace

std::optional<NpyArray> parse_npy(const InputFile& file, const std::string& name,
                                  std::string_view content) {
  return NpyParser(file, name, content).parse();
}

std::string npy_header(std::string_view type, const std::vector<std::int64_t>& shape) {
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({},), }}",
                                   type, fmt::join(shape, ", "));
  // The data begins at a multiple of 64 bytes.
  const std::size_t prefix = kMagic.size() + 4;
  header.resize((prefix + header.size() + 1 + 63) / 64 * 64 - prefix - 1, ' ');
  header += '\n';
  std::string bytes(kMagic);
  bytes += '\x01';
  bytes += '\0';
  append_little_endian(static_cast<std::uint16_t>(header.size()), bytes);
  return bytes + header;
}

std::string npy_bytes(const NpyArray& array) {
  std::string bytes = npy_header(array.has_integers ? "<i8" : "<f8", array.shape);
  for (const double value : array.values)
    array.has_integers ? append_little_endian(static_cast<std::int64_t>(value), bytes)
                       : append_little_endian(value, bytes);
  return bytes;
}

}  // namespace isomatch
