// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <string>

#include "io/input_file.h"
#include "io/mesh/binary_cursor.h"
#include "io/mesh/ply_header.h"
#include "io/text_cursor.h"

/// What follows the header of a PLY file, value by value, in its two encodings. Both classes have
/// the same members, documented at the first.
namespace isomatch::mesh_io {

class AsciiPlyBody {
 public:
  AsciiPlyBody(const InputFile& file, const PlyHeader& header) : cursor_(file) {
    cursor_.set_position(header.body);
  }

  /// Stand before the first and behind the last value of element number `index`.
  void begin_element(const PlyElement& element, int index) {
    if (!cursor_.find_content())
      cursor_.fail(fmt::format("the file ends after {} of {} elements {}", index, element.count,
                               in_quotes(element.name)));
  }
  void end_element() {
    cursor_.expect_line_end();
    cursor_.skip_line();
  }

  /// The next value. Some programs write 200.0 for an integer.
  double scalar(PlyType type) {
    const bool floating = type == PlyType::kFloat32 || type == PlyType::kFloat64;
    return floating ? cursor_.coordinate() : cursor_.whole_number();
  }
  /// Passes over `count` values. What they are is not looked at: normals may well be nan.
  void skip(PlyType, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i)
      if (cursor_.word().empty()) cursor_.fail("expected more values, but the line ends");
  }
  /// Whether all of the file has been read, but for blank lines.
  bool at_end() { return !cursor_.find_content(); }
  /// Throws `BadFile` with the place of the last value.
  [[noreturn]] void fail(const std::string& reason) const { cursor_.fail(reason); }

 private:
  TextCursor cursor_;
};

template <std::endian kByteOrder>
class BinaryPlyBody {
 public:
  BinaryPlyBody(const InputFile& file, const PlyHeader& header) : cursor_(file, header.body) {}

  void begin_element(const PlyElement&, int) {}
  void end_element() {}

  double scalar(PlyType type) {
    switch (type) {
      case PlyType::kInt8:
        return cursor_.template take<std::int8_t>();
      case PlyType::kUint8:
        return cursor_.template take<std::uint8_t>();
      case PlyType::kInt16:
        return cursor_.template take<std::int16_t>();
      case PlyType::kUint16:
        return cursor_.template take<std::uint16_t>();
      case PlyType::kInt32:
        return cursor_.template take<std::int32_t>();
      case PlyType::kUint32:
        return cursor_.template take<std::uint32_t>();
      case PlyType::kFloat32:
        return cursor_.template take<float>();
      case PlyType::kFloat64:
        break;
    }
    return cursor_.template take<double>();
  }

  void skip(PlyType type, std::int64_t count) { cursor_.skip(ply_size(type), count); }
  bool at_end() const { return cursor_.remaining() == 0; }
  [[noreturn]] void fail(const std::string& reason) const { cursor_.fail(reason); }

 private:
  BinaryCursor<kByteOrder> cursor_;
};

}  // namespace isomatch::mesh_io
