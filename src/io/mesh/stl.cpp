// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/point_index.h"
#include "io/mesh/binary_cursor.h"
#include "io/mesh/checks.h"
#include "io/mesh/formats.h"
#include "io/text_cursor.h"

namespace isomatch::mesh_io {
namespace {

// A binary file: a free text, the number of triangles, and for each triangle its normal, three
// corners, and an attribute.
constexpr std::int64_t kTextBytes = 80;
constexpr std::int64_t kLeastBinaryBytes = kTextBytes + sizeof(std::uint32_t);
constexpr std::int64_t kNormalBytes = 3 * sizeof(float);
constexpr std::int64_t kAttributeBytes = sizeof(std::uint16_t);
constexpr std::int64_t kTriangleBytes = 4 * kNormalBytes + kAttributeBytes;

using StlCursor = BinaryCursor<std::endian::little>;

ReadResult finish(PointIndex points, std::vector<Face> faces) {
  ReadResult result;
  result.mesh = {points.take_points(), std::move(faces)};
  result.report.merged_vertices = 3 * result.mesh.num_faces() - result.mesh.num_vertices();
  return result;
}

Point read_point(StlCursor& cursor) {
  Point point;
  for (double& coordinate : point) coordinate = cursor.take<float>();
  return point;
}

ReadResult read_binary(const InputFile& file) {
  StlCursor cursor(file, file.begin() + kTextBytes);
  const auto announced = cursor.take<std::uint32_t>();
  const int count =
      checked_count(cursor, announced, "triangles", cursor.remaining(), kTriangleBytes);
  PointIndex points;
  std::vector<Face> faces(count);
  for (Face& face : faces) {
    cursor.skip(kNormalBytes);
    for (int& vertex : face) vertex = points.number_of(read_point(cursor));
    cursor.skip(kAttributeBytes);
  }
  cursor.expect_end();
  return finish(std::move(points), std::move(faces));
}

/// The layout of lines is free, except that the name of a solid lasts to the end of its line.
class AsciiReader {
 public:
  explicit AsciiReader(const InputFile& file) : cursor_(file) {}

  ReadResult read() {
    while (cursor_.find_content()) {
      expect({"solid"});
      cursor_.skip_line();
      while (read_facet()) {
      }
      cursor_.skip_line();
    }
    return finish(std::move(points_), std::move(faces_));
  }

 private:
  /// False if the solid ends instead.
  bool read_facet() {
    const std::string_view keyword = next_word();
    if (equal_ignoring_case(keyword, "endsolid")) return false;
    if (!equal_ignoring_case(keyword, "facet"))
      cursor_.fail(fmt::format("expected facet or endsolid, found {}", in_quotes(keyword)));
    expect({"normal"});
    // Not looked at, since it follows from the corners and is often nan.
    for (int axis = 0; axis < 3; ++axis) next_word();
    expect({"outer", "loop"});
    Face& face = faces_.emplace_back();
    for (int& vertex : face) vertex = read_vertex();
    expect({"endloop", "endfacet"});
    return true;
  }

  int read_vertex() {
    expect({"vertex"});
    Point point;
    for (double& coordinate : point) {
      cursor_.find_content();
      coordinate = cursor_.coordinate();
    }
    return points_.number_of(point);
  }

  void expect(std::initializer_list<std::string_view> keywords) {
    for (const std::string_view keyword : keywords) {
      const std::string_view word = next_word();
      if (!equal_ignoring_case(word, keyword))
        cursor_.fail(fmt::format("expected {}, found {}", keyword, in_quotes(word)));
    }
  }

  std::string_view next_word() {
    if (!cursor_.find_content()) cursor_.fail("the file ends before endsolid");
    return cursor_.word();
  }

  TextCursor cursor_;
  PointIndex points_;
  std::vector<Face> faces_;
};

bool begins_with_solid(const InputFile& file) {
  TextCursor cursor(file);
  cursor.find_content();
  return equal_ignoring_case(cursor.word(), "solid");
}

/// Whether the size is that of a binary file with the number of triangles that it announces.
bool has_binary_size(const InputFile& file) {
  StlCursor cursor(file, file.begin() + kTextBytes);
  const std::int64_t triangles = cursor.take<std::uint32_t>();
  return cursor.remaining() == triangles * kTriangleBytes;
}

}  // namespace

ReadResult read_stl(const InputFile& file) {
  const bool solid = begins_with_solid(file);
  if (file.end() - file.begin() < kLeastBinaryBytes) {
    if (!solid) file.fail("too short for a binary STL file, and an ASCII one begins with solid");
    return AsciiReader(file).read();
  }
  // Many binary files begin with solid too, but text has no zero bytes, and almost every binary
  // header has some.
  const bool text =
      file.content().substr(0, kLeastBinaryBytes).find('\0') == std::string_view::npos;
  return solid && text && !has_binary_size(file) ? AsciiReader(file).read() : read_binary(file);
}

}  // namespace isomatch::mesh_io
