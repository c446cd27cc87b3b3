// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "io/mesh/checks.h"
#include "io/text_cursor.h"

namespace isomatch::mesh_io {
namespace {

/// A word of the header and what it stands for.
template <class T>
using Word = std::pair<std::string_view, T>;

constexpr std::array<Word<PlyFormat>, 3> kFormats = {
    {{"ascii", PlyFormat::kAscii},
     {"binary_little_endian", PlyFormat::kBinaryLittleEndian},
     {"binary_big_endian", PlyFormat::kBinaryBigEndian}}};

constexpr std::array<Word<PlyType>, 16> kTypes = {{{"char", PlyType::kInt8},
                                                   {"int8", PlyType::kInt8},
                                                   {"uchar", PlyType::kUint8},
                                                   {"uint8", PlyType::kUint8},
                                                   {"short", PlyType::kInt16},
                                                   {"int16", PlyType::kInt16},
                                                   {"ushort", PlyType::kUint16},
                                                   {"uint16", PlyType::kUint16},
                                                   {"int", PlyType::kInt32},
                                                   {"int32", PlyType::kInt32},
                                                   {"uint", PlyType::kUint32},
                                                   {"uint32", PlyType::kUint32},
                                                   {"float", PlyType::kFloat32},
                                                   {"float32", PlyType::kFloat32},
                                                   {"double", PlyType::kFloat64},
                                                   {"float64", PlyType::kFloat64}}};

template <class T, std::size_t N>
T read_choice(TextCursor& cursor, const std::array<Word<T>, N>& choices, std::string_view what) {
  const std::string_view word = cursor.peek_word();
  for (const auto& [name, value] : choices) {
    if (name != word) continue;
    cursor.word();
    return value;
  }
  cursor.fail(fmt::format("unknown {} {}", what, in_quotes(word)));
}

PlyFormat read_format(TextCursor& cursor) {
  const PlyFormat format = read_choice(cursor, kFormats, "format");
  if (const std::string_view version = cursor.word(); version != "1.0")
    cursor.fail(fmt::format("unknown version {} of the format", in_quotes(version)));
  return format;
}

std::string elements_called(const std::string& name) { return in_quotes(name) + " elements"; }

PlyElement read_element(TextCursor& cursor) {
  PlyElement element;
  element.place = cursor.position();
  element.name = cursor.word();
  // Every element takes at least a byte; how many it takes is known at the end of the header.
  element.count =
      checked_count(cursor, cursor.integer(), elements_called(element.name), cursor.remaining(), 1);
  return element;
}

PlyProperty read_property(TextCursor& cursor) {
  PlyProperty property;
  if (cursor.peek_word() == "list") {
    cursor.word();
    property.count_type = read_choice(cursor, kTypes, "type");
  }
  property.type = read_choice(cursor, kTypes, "type");
  property.name = cursor.word();
  if (property.name.empty()) cursor.fail("the property has no name");
  return property;
}

/// Reads one line of the header; false if it is the last.
bool read_line(TextCursor& cursor, std::optional<PlyFormat>& format,
               std::vector<PlyElement>& elements) {
  if (!cursor.find_content()) cursor.fail("the file ends before end_header");
  const std::string_view keyword = cursor.word();
  if (keyword == "comment" || keyword == "obj_info") {
    cursor.skip_line();
    return true;
  }
  if (keyword == "format") {
    format = read_format(cursor);
  } else if (keyword == "element") {
    elements.push_back(read_element(cursor));
  } else if (keyword == "property") {
    if (elements.empty()) cursor.fail("a property stands before the first element");
    elements.back().properties.push_back(read_property(cursor));
  } else if (keyword != "end_header") {
    cursor.fail(fmt::format("unknown keyword {} in the header", in_quotes(keyword)));
  }
  cursor.expect_line_end();
  cursor.skip_line();
  return keyword != "end_header";
}

/// Least number of bytes that one element takes.
std::int64_t least_size(const PlyElement& element, PlyFormat format) {
  std::int64_t size = 0;
  for (const PlyProperty& property : element.properties)
    size += format == PlyFormat::kAscii ? 2 : ply_size(property.count_type.value_or(property.type));
  return size;
}

/// Takes a copy of the cursor, which it moves to the lines at fault.
void check_elements(TextCursor cursor, const PlyHeader& header) {
  // The last line of a text may go without its end.
  const std::int64_t available = cursor.remaining() + (header.format == PlyFormat::kAscii ? 1 : 0);
  for (const PlyElement& element : header.elements) {
    cursor.set_position(element.place);
    if (element.name == "vertex" && &element != header.find("vertex"))
      cursor.fail("a second element called 'vertex'");
    if (element.count == 0) continue;
    if (element.properties.empty())
      cursor.fail(fmt::format("element {} has no properties", in_quotes(element.name)));
    checked_count(cursor, element.count, elements_called(element.name), available,
                  least_size(element, header.format));
  }
}

}  // namespace

int ply_size(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32:
      return 4;
    case PlyType::kFloat64:
      break;
  }
  return 8;
}

const PlyElement* PlyHeader::find(std::string_view name) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const PlyElement& element) { return element.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(const InputFile& file) {
  TextCursor cursor(file);
  if (const std::string_view magic = cursor.word(); magic != "ply")
    cursor.fail(fmt::format("expected ply, found {}", in_quotes(magic)));
  cursor.expect_line_end();
  cursor.skip_line();
  PlyHeader header;
  std::optional<PlyFormat> format;
  while (read_line(cursor, format, header.elements)) {
  }
  if (!format) cursor.fail("the header does not name the format");
  header.format = *format;
  header.body = cursor.position();
  check_elements(cursor, header);
  return header;
}

}  // namespace isomatch::mesh_io
