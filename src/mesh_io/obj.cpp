// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <cstdint>
#include <string_view>
#include <utility>

#include "mesh_io/checks.h"
#include "mesh_io/formats.h"
#include "mesh_io/polygon.h"
#include "mesh_io/text_writer.h"
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
    if (index == 0) cursor_.fail("vertex index 0 is out of range, vertices are counted from 1");
    if (index < 0) return vertex_before(index);
    if (index > highest_index_) {
      highest_index_ = index;
      highest_place_ = place;
    }
    // Too large an index wraps here and is found by check_highest_index.
    return static_cast<int>(index - 1);
  }

  int vertex_before(std::int64_t index) const {
    const std::int64_t vertex = result_.mesh.num_vertices() + index;
    if (vertex < 0)
      cursor_.fail(fmt::format("vertex index {} is out of range, {} vertices stand before it",
                               index, result_.mesh.num_vertices()));
    return static_cast<int>(vertex);
  }

  void check_highest_index() {
    if (highest_index_ <= result_.mesh.num_vertices()) return;
    cursor_.set_position(highest_place_);
    cursor_.fail(
        fmt::format("vertex index {} is out of range, there are {} vertices counted from 1",
                    highest_index_, result_.mesh.num_vertices()));
  }

  TextCursor cursor_;
  ReadResult result_;
  std::int64_t highest_index_ = 0;
  const char* highest_place_;
};

}  // namespace

ReadResult read_obj(const InputFile& file) { return ObjReader(file).read(); }

void write_obj(const Mesh& mesh, AtomicFile& file) {
  write_text(mesh, {.before_vertex = "v ", .before_face = "f ", .first_index = 1}, file);
}

}  // namespace isomatch::mesh_io
