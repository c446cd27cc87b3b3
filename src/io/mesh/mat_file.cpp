// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/mat_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <string_view>

#include "io/byte_order.h"
#include "io/inflate.h"

namespace isomatch::mesh_io {
namespace {

constexpr std::size_t kHeaderBytes = 128, kTagBytes = 8;
/// Bounds the recursion.
constexpr int kDeepestStruct = 8;

std::size_t size_of(std::uint32_t type) {
  switch (type) {
    case kInt8:
    case kUint8:
      return 1;
    case kInt16:
    case kUint16:
      return 2;
    case kInt32:
    case kUint32:
    case kSingle:
      return 4;
    case kDouble:
    case kInt64:
    case kUint64:
      return 8;
    default:
      return 0;
  }
}

/// A piece of data with its type.
struct Element {
  std::uint32_t type;
  std::string_view data;
};

/// Walks through elements. Failures name the byte of the file where the variable begins, since what
/// is compressed has no bytes of its own there.
class MatCursor {
 public:
  MatCursor(const InputFile& file, const char* variable, std::string_view bytes, std::endian order)
      : file_(&file), variable_(variable), bytes_(bytes), order_(order) {}

  bool at_end() const { return bytes_.empty(); }
  std::string_view rest() const { return bytes_; }
  MatCursor inside(std::string_view bytes) const { return {*file_, variable_, bytes, order_}; }
  [[noreturn]] void fail(const std::string& reason) const {
    file_->fail_at_byte(variable_, reason);
  }

  template <class T>
  T load(std::string_view bytes) const {
    return isomatch::load<T>(std::to_address(bytes.begin()), order_);
  }

  Element take() {
    if (bytes_.size() < kTagBytes) fail("the variable ends too early");
    const auto word = load<std::uint32_t>(bytes_);
    // Four bytes at most may stand in the tag itself.
    if (const std::uint32_t size = word >> 16; size > 0) {
      if (size > 4) fail("malformed: a short element of more than 4 bytes");
      const Element element{word & 0xffff, bytes_.substr(4, size)};
      bytes_.remove_prefix(kTagBytes);
      return element;
    }
    const std::size_t size = load<std::uint32_t>(bytes_.substr(4));
    if (size > bytes_.size() - kTagBytes)
      fail(fmt::format("{} bytes announced, but {} follow", size, bytes_.size() - kTagBytes));
    const Element element{word, bytes_.substr(kTagBytes, size)};
    const std::size_t padded = word == kCompressed ? size : (size + 7) / 8 * 8;
    bytes_.remove_prefix(std::min(kTagBytes + padded, bytes_.size()));
    return element;
  }

  double number(std::uint32_t type, std::string_view bytes) const {
    switch (type) {
      case kInt8:
        return load<std::int8_t>(bytes);
      case kUint8:
        return load<std::uint8_t>(bytes);
      case kInt16:
        return load<std::int16_t>(bytes);
      case kUint16:
        return load<std::uint16_t>(bytes);
      case kInt32:
        return load<std::int32_t>(bytes);
      case kUint32:
        return load<std::uint32_t>(bytes);
      case kSingle:
        return load<float>(bytes);
      case kInt64:
        return static_cast<double>(load<std::int64_t>(bytes));
      case kUint64:
        return static_cast<double>(load<std::uint64_t>(bytes));
      default:
        return load<double>(bytes);
    }
  }

  /// The next element, which must hold numbers.
  std::vector<double> take_numbers() {
    const Element element = take();
    const std::size_t size = size_of(element.type);
    if (size == 0 || element.data.size() % size != 0) fail("malformed: numbers expected");
    std::vector<double> numbers(element.data.size() / size);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = number(element.type, element.data.substr(i * size, size));
    return numbers;
  }

 private:
  const InputFile* file_;
  const char* variable_;
  std::string_view bytes_;
  std::endian order_;
};

/// What all arrays begin with.
struct ArrayHead {
  std::uint32_t array_class;
  std::vector<double> dimensions;
  std::string name;
};

ArrayHead take_head(MatCursor& cursor) {
  const Element flags = cursor.take();
  if (flags.type != kUint32 || flags.data.size() < 4) cursor.fail("malformed: no array flags");
  const auto word = cursor.load<std::uint32_t>(flags.data);
  std::vector<double> dimensions = cursor.take_numbers();
  return {word & 0xff, std::move(dimensions), std::string(cursor.take().data)};
}

bool is_numeric(const ArrayHead& head) {
  return head.array_class >= kDoubleClass && head.array_class <= kUint64Class;
}

std::optional<MatArray> take_array(MatCursor& cursor, const ArrayHead& head) {
  if (!is_numeric(head) || head.dimensions.size() != 2) return std::nullopt;
  const double rows = head.dimensions[0], columns = head.dimensions[1];
  std::vector<double> values;
  // Nothing may stand for nothing.
  if (!cursor.at_end()) values = cursor.take_numbers();
  if (rows < 0 || columns < 0 || rows * columns != static_cast<double>(values.size()))
    cursor.fail(fmt::format("a matrix of {} x {} has {} values", rows, columns, values.size()));
  if (std::max(rows, columns) > std::numeric_limits<int>::max())
    cursor.fail("a matrix is larger than this program can number");
  return MatArray{static_cast<int>(rows), static_cast<int>(columns), std::move(values)};
}

std::vector<std::string> take_field_names(MatCursor& cursor) {
  const std::vector<double> lengths = cursor.take_numbers();
  const std::string_view names = cursor.take().data;
  if (lengths.size() != 1 || !(lengths[0] >= 1) || lengths[0] > 1000)
    cursor.fail("malformed: names of fields");
  const auto length = static_cast<std::size_t>(lengths[0]);
  std::vector<std::string> result;
  for (std::size_t at = 0; at + length <= names.size(); at += length) {
    const std::string_view name = names.substr(at, length);
    result.emplace_back(name.substr(0, name.find('\0')));
  }
  return result;
}

MatVariable take_variable(MatCursor cursor, int depth = 0);

/// The fields of one struct; none of an empty array of structs, which has names only.
std::vector<MatVariable> take_fields(MatCursor& cursor, const std::vector<std::string>& names,
                                     int depth) {
  std::vector<MatVariable> fields;
  for (const std::string& name : names) {
    if (cursor.at_end()) break;
    const Element element = cursor.take();
    if (element.type != kMatrix) cursor.fail("malformed: a field is no array");
    if (element.data.empty()) continue;
    fields.push_back(take_variable(cursor.inside(element.data), depth + 1));
    fields.back().name = name;
  }
  return fields;
}

std::vector<MatVariable> take_structs(MatCursor& cursor, int depth) {
  const std::vector<std::string> names = take_field_names(cursor);
  std::vector<MatVariable> structs;
  do {
    structs.push_back(
        {fmt::format("({})", structs.size() + 1), {}, take_fields(cursor, names, depth)});
  } while (!names.empty() && !cursor.at_end());
  if (structs.size() == 1) return std::move(structs.front().fields);
  return structs;
}

MatVariable take_variable(MatCursor cursor, int depth) {
  const ArrayHead head = take_head(cursor);
  MatVariable variable{head.name, take_array(cursor, head), {}};
  if (head.array_class == kStructClass && depth <= kDeepestStruct)
    variable.fields = take_structs(cursor, depth);
  return variable;
}

/// The one element in a compressed one.
std::string decompressed(const MatCursor& cursor, std::string_view data) {
  Inflater inflater(data);
  const std::string tag = inflater.take(kTagBytes);
  if (tag.size() < kTagBytes) cursor.fail("its compressed data is damaged");
  const std::size_t size = cursor.load<std::uint32_t>(std::string_view(tag).substr(4));
  std::string bytes = tag + inflater.take(size);
  if (bytes.size() != kTagBytes + size)
    cursor.fail("its compressed data is damaged or ends too early");
  return bytes;
}

std::endian byte_order(const InputFile& file) {
  const std::string_view content = file.content();
  if (content.substr(0, 8) == "\x89HDF\r\n\x1a\n" || content.starts_with("MATLAB 7.3"))
    file.fail("is a MATLAB 7.3 file, which is not supported; save it with -v7");
  const std::string_view mark =
      content.substr(0, kHeaderBytes).substr(std::min(content.size(), kHeaderBytes - 2));
  if (mark == "IM") return std::endian::little;
  if (mark == "MI") return std::endian::big;
  file.fail("is not a MATLAB file of level 5");
}

}  // namespace

std::vector<MatVariable> read_mat_variables(const InputFile& file) {
  const std::endian order = byte_order(file);
  std::vector<MatVariable> variables;
  std::string_view rest = file.content().substr(kHeaderBytes);
  while (!rest.empty()) {
    MatCursor cursor(file, std::to_address(rest.begin()), rest, order);
    const Element element = cursor.take();
    if (element.type == kCompressed) {
      const std::string bytes = decompressed(cursor, element.data);
      MatCursor inside = cursor.inside(bytes);
      const Element array = inside.take();
      if (array.type == kMatrix && !array.data.empty())
        variables.push_back(take_variable(inside.inside(array.data)));
    } else if (element.type == kMatrix) {
      if (!element.data.empty()) variables.push_back(take_variable(cursor.inside(element.data)));
    } else {
      cursor.fail(fmt::format("malformed: {} is no type of a variable", element.type));
    }
    rest = cursor.rest();
  }
  return variables;
}

}  // namespace isomatch::mesh_io
