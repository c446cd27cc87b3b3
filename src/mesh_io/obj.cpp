// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>
#include <limits>
#include <utility>

#include "mesh_io/checks.h"
#include "mesh_io/formats.h"
#include "mesh_io/polygon.h"
#include "text_cursor.h"

namespace isomatch::mesh_io {
namespace {

class ObjReader {
 public:
  explicit ObjReader(const InputFile& file)
      : cursor_(file, {.comments = true, .continuations = true}), highest_place_(file.begin()) {}

  ReadResult read() {
    while (cursor_.find_content()) {
      const std::string_view keyword = cursor_.word();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "f")
        read_face();
      cursor_.skip_line();
    }
    check_highest_index();
    return std::move(result_);
  }

 private:
  /// A weight or a colour may follow the position. The weight matters to rational curves only.
  void read_vertex() {
    const double x = cursor_.number(), y = cursor_.number(), z = cursor_.number();
    result_.mesh.vertices.emplace_back(x, y, z);
  }

  void read_face() {
    Polygon polygon(result_);
    while (!cursor_.at_line_end()) polygon.add_corner(read_corner());
    check_corners(cursor_, polygon.corners());
  }

  /// The vertex of a corner v, v/vt, v//vn or v/vt/vn. Positive indices count from 1 and may name a
  /// vertex further down; negative ones count back from the last vertex so far.
  int read_corner() {
    const char* const place = cursor_.position();
    const std::int64_t index = cursor_.leading_integer('/');
    const std::int64_t vertex = index > 0 ? index - 1 : result_.mesh.num_vertices() + index;
    if (index == 0 || vertex < 0 || vertex > std::numeric_limits<int>::max()) fail_index(index);
    if (index > highest_index_) {
      highest_index_ = index;
      highest_place_ = place;
    }
    return static_cast<int>(vertex);
  }

  void check_highest_index() {
    if (highest_index_ <= result_.mesh.num_vertices()) return;
    cursor_.set_position(highest_place_);
    fail_index(highest_index_);
  }

  [[noreturn]] void fail_index(std::int64_t index) const {
    cursor_.fail(
        fmt::format("vertex index {} is out of range, there are {} vertices counted from 1", index,
                    result_.mesh.num_vertices()));
  }

  TextCursor cursor_;
  ReadResult result_;
  std::int64_t highest_index_ = 0;
  const char* highest_place_;
};

}  // namespace

ReadResult read_obj(const InputFile& file) { return ObjReader(file).read(); }

void write_obj(const Mesh& mesh, AtomicFile& file) {
  fmt::memory_buffer line;
  for (const Point& p : mesh.vertices) {
    line.clear();
    fmt::format_to(std::back_inserter(line), FMT_COMPILE("v {} {} {}\n"), p.x(), p.y(), p.z());
    file.write({line.data(), line.size()});
  }
  for (const auto& [a, b, c] : mesh.faces) {
    line.clear();
    fmt::format_to(std::back_inserter(line), FMT_COMPILE("f {} {} {}\n"), a + 1, b + 1, c + 1);
    file.write({line.data(), line.size()});
  }
}

}  // namespace isomatch::mesh_io
