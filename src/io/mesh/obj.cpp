// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "io/mesh/checks.h"
#include "io/mesh/formats.h"
#include "io/mesh/polygon.h"
#include "io/text_cursor.h"

namespace isomatch::mesh_io {
namespace {

class ObjReader {
 public:
  explicit ObjReader(const InputFile& file)
      : file_(file),
        cursor_(file, {.comments = true, .continuations = true}),
        highest_place_(file.begin()) {}

  ReadResult read() {
    read_lines();
    return std::move(result_);
  }

  ReadResult read_with_texture() {
    textured_ = true;
    read_lines();
    check_coordinate_indices();
    return std::move(result_);
  }

 private:
  void read_lines() {
    while (cursor_.find_content()) {
      const std::string_view keyword = cursor_.word();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "f")
        read_face();
      else if (textured_ && keyword == "vt")
        read_coordinates();
      else if (textured_ && keyword == "usemtl")
        use_material(cursor_.rest_of_line());
      cursor_.skip_line();
    }
    check_highest_index();
  }

  /// A weight or a colour may follow the position. The weight matters to rational curves only.
  void read_vertex() {
    const double x = cursor_.coordinate(), y = cursor_.coordinate(), z = cursor_.coordinate();
    result_.mesh.vertices.emplace_back(x, y, z);
  }

  void read_face() {
    Polygon polygon(result_);
    face_coordinates_.clear();
    while (!cursor_.at_line_end()) {
      if (textured_) face_coordinates_.push_back(coordinates_of(cursor_.peek_word()));
      polygon.add_corner(read_corner());
    }
    if (textured_) cover_fan();
  }

  void read_coordinates() {
    const double u = cursor_.number();
    result_.texture.coordinates.emplace_back(u, cursor_.at_line_end() ? 0 : cursor_.number());
  }

  void use_material(const std::string& name) {
    material_ = Texture::kNone;
    if (name.empty()) return;
    std::vector<std::string>& names = result_.texture.materials;
    material_ = static_cast<int>(std::ranges::find(names, name) - names.begin());
    if (material_ == std::ssize(names)) names.push_back(name);
  }

  /// The texture coordinates of a corner v/vt or v/vt/vn.
  int coordinates_of(std::string_view corner) const {
    const std::size_t slash = corner.find('/');
    if (slash == std::string_view::npos) return Texture::kNone;
    const std::string_view rest = corner.substr(slash + 1, corner.find('/', slash + 1) - slash - 1);
    if (rest.empty()) return Texture::kNone;
    int index = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), index);
    const int count = static_cast<int>(result_.texture.coordinates.size());
    if (error != std::errc() || end != rest.data() + rest.size() || index == 0 || index < -count)
      cursor_.fail(fmt::format("bad index of texture coordinates in {}", in_quotes(corner)));
    return index > 0 ? index - 1 : count + index;
  }

  /// Gives the fan of triangles that the last face became its coordinates and material.
  void cover_fan() {
    Texture& texture = result_.texture;
    const std::vector<int>& at = face_coordinates_;
    const bool covered = std::ranges::count(at, Texture::kNone) == 0;
    for (std::size_t k = 2; k < at.size(); ++k) {
      texture.corners.push_back(covered
                                    ? std::array{at[0], at[k - 1], at[k]}
                                    : std::array{Texture::kNone, Texture::kNone, Texture::kNone});
      texture.face_material.push_back(material_);
    }
  }

  void check_coordinate_indices() const {
    const int count = static_cast<int>(result_.texture.coordinates.size());
    for (const auto& corners : result_.texture.corners)
      for (const int index : corners)
        if (index >= count)
          file_.fail(fmt::format("texture coordinates {} are out of range, there are {}", index + 1,
                                 count));
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

  const InputFile& file_;
  TextCursor cursor_;
  ReadResult result_;
  bool textured_ = false;
  int material_ = Texture::kNone;
  /// Of the corners of the face that is being read.
  std::vector<int> face_coordinates_;
  std::int64_t highest_index_ = 0;
  const char* highest_place_;
};

}  // namespace

ReadResult read_obj(const InputFile& file) { return ObjReader(file).read(); }

ReadResult read_textured_obj(const InputFile& file) { return ObjReader(file).read_with_texture(); }

}  // namespace isomatch::mesh_io
