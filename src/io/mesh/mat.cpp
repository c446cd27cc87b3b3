// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/mesh/checks.h"
#include "io/mesh/formats.h"
#include "io/mesh/mat_file.h"
#include "isomatch/error.h"

namespace isomatch::mesh_io {
namespace {

using Arrays = std::map<std::string_view, const MatArray*>;

constexpr std::array<std::string_view, 2> kPointNames = {"VERT", "vertices"};
constexpr std::array<std::string_view, 2> kCornerNames = {"TRIV", "faces"};
constexpr std::size_t kMostNames = 6;

/// The first of `names` that is there, empty if none is.
std::string_view present(const Arrays& arrays, std::span<const std::string_view> names) {
  for (const std::string_view name : names)
    if (arrays.contains(name)) return name;
  return {};
}

bool has_axes(const Arrays& arrays) {
  return arrays.contains("X") && arrays.contains("Y") && arrays.contains("Z");
}

bool is_shape(const Arrays& arrays) {
  return (!present(arrays, kPointNames).empty() || has_axes(arrays)) &&
         !present(arrays, kCornerNames).empty();
}

struct NamedShape {
  /// How MATLAB calls the struct; empty if it is no struct.
  std::string name;
  Arrays arrays;
};

std::string field_name(const std::string& of, const std::string& field) {
  return of.empty() || field.starts_with('(') ? of + field : of + "." + field;
}

/// Appends all shapes among `variables`, which are the fields of `name`, and further inside.
void collect_shapes(const std::string& name, const std::vector<MatVariable>& variables,
                    std::vector<NamedShape>& shapes) {
  Arrays arrays;
  for (const MatVariable& variable : variables)
    if (variable.array) arrays[variable.name] = &*variable.array;
  if (is_shape(arrays)) shapes.push_back({name, std::move(arrays)});
  for (const MatVariable& variable : variables)
    collect_shapes(field_name(name, variable.name), variable.fields, shapes);
}

std::string shown_name(const std::string& name) {
  if (name.empty()) return "the variables by themselves";
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.()";
  return name.find_first_not_of(kPlain) == std::string::npos ? name : in_quotes(name);
}

std::string list(const std::vector<NamedShape>& shapes) {
  std::string names;
  for (std::size_t i = 0; i < std::min(shapes.size(), kMostNames); ++i)
    names += (i == 0 ? "" : ", ") + shown_name(shapes[i].name);
  return shapes.size() > kMostNames ? names + ", ..." : names;
}

Arrays find_shape(const InputFile& file, const std::vector<MatVariable>& variables) {
  std::vector<NamedShape> shapes;
  collect_shapes("", variables, shapes);
  if (shapes.empty())
    file.fail(
        "has no shape: X, Y, Z, or VERT, or vertices, with TRIV or faces, by themselves or in a "
        "struct");
  if (shapes.size() > 1)
    file.fail(
        fmt::format("has {} shapes: {}; save one of them by itself", shapes.size(), list(shapes)));
  return std::move(shapes.front().arrays);
}

/// Matrices of three columns, or else of three rows, read as so many triples.
class Triples {
 public:
  Triples(const InputFile& file, std::string_view name, const MatArray& array)
      : array_(array), is_transposed_(array.columns != 3) {
    if (array.columns != 3 && array.rows != 3)
      file.fail(fmt::format("{} is {} x {}, but must have three columns", name, array.rows,
                            array.columns));
  }

  int size() const { return is_transposed_ ? array_.columns : array_.rows; }
  double operator()(int i, int k) const {
    const std::size_t row = is_transposed_ ? k : i, column = is_transposed_ ? i : k;
    return array_.values[column * array_.rows + row];
  }

 private:
  const MatArray& array_;
  bool is_transposed_;
};

std::vector<Point> joined(const InputFile& file, const Arrays& arrays) {
  const std::array<const MatArray*, 3> axes{arrays.at("X"), arrays.at("Y"), arrays.at("Z")};
  const std::size_t count = axes[0]->values.size();
  if (axes[1]->values.size() != count || axes[2]->values.size() != count)
    file.fail("X, Y and Z are not equally many");
  std::vector<Point> points(count);
  for (std::size_t v = 0; v < count; ++v)
    for (int k = 0; k < 3; ++k) points[v][k] = axes[k]->values[v];
  return points;
}

std::vector<Point> points_of(const InputFile& file, const Arrays& arrays) {
  const std::string_view name = present(arrays, kPointNames);
  if (name.empty()) return joined(file, arrays);
  const Triples triples(file, name, *arrays.at(name));
  std::vector<Point> points(triples.size());
  for (int v = 0; v < triples.size(); ++v)
    for (int k = 0; k < 3; ++k) points[v][k] = triples(v, k);
  return points;
}

std::vector<Face> faces_of(const InputFile& file, const Arrays& arrays, std::size_t vertices) {
  const std::string_view name = present(arrays, kCornerNames);
  const Triples triples(file, name, *arrays.at(name));
  std::vector<Face> faces(triples.size());
  for (int f = 0; f < triples.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const double number = triples(f, k);
      if (!(number >= 1 && number <= static_cast<double>(vertices)) || std::floor(number) != number)
        file.fail(
            fmt::format("vertex {} in {} is out of range, there are {} vertices counted from 1",
                        number, name, vertices));
      faces[f][k] = static_cast<int>(number) - 1;
    }
  }
  return faces;
}

/// The bytes of elements in the machine's own byte order, of which the header tells.
class MatBytes {
 public:
  template <class T>
  void append(std::uint32_t type, std::span<const T> values) {
    append_tag(type, values.size_bytes());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    bytes_.resize((bytes_.size() + 7) / 8 * 8);
  }

  void append(const MatBytes& other) { bytes_ += other.bytes_; }

  void append_tag(std::uint32_t type, std::size_t size) {
    for (const std::uint32_t word : {type, static_cast<std::uint32_t>(size)})
      bytes_.append(reinterpret_cast<const char*>(&word), sizeof(word));
  }

  /// What an array begins with.
  void append_head(std::uint32_t array_class, std::array<std::int32_t, 2> size,
                   std::string_view name) {
    append<std::uint32_t>(kUint32, std::array{array_class, 0U});
    append<std::int32_t>(kInt32, size);
    append<char>(kInt8, name);
  }

  std::size_t size() const { return bytes_.size(); }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

MatBytes matrix(int rows, int columns, const std::vector<double>& values) {
  MatBytes content;
  content.append_head(kDoubleClass, {rows, columns}, "");
  content.append<double>(kDouble, values);
  MatBytes result;
  result.append_tag(kMatrix, content.size());
  result.append(content);
  return result;
}

MatBytes coordinates(const Mesh& mesh, int axis) {
  std::vector<double> values;
  values.reserve(mesh.vertices.size());
  for (const Point& point : mesh.vertices) values.push_back(point[axis]);
  return matrix(mesh.num_vertices(), 1, values);
}

MatBytes corners(const Mesh& mesh) {
  std::vector<double> values;
  values.reserve(3 * mesh.faces.size());
  for (int k = 0; k < 3; ++k)
    for (const Face& face : mesh.faces) values.push_back(face[k] + 1);
  return matrix(mesh.num_faces(), 3, values);
}

MatBytes surface(const Mesh& mesh) {
  constexpr std::size_t kNameBytes = 8;
  std::string names;
  for (std::string name : {"X", "Y", "Z", "TRIV"}) {
    name.resize(kNameBytes);
    names += name;
  }
  MatBytes content;
  content.append_head(kStructClass, {1, 1}, "surface");
  // A single number stands in the tag.
  content.append_tag(kInt32 | 4 << 16, kNameBytes);
  content.append<char>(kInt8, names);
  for (int axis = 0; axis < 3; ++axis) content.append(coordinates(mesh, axis));
  content.append(corners(mesh));
  return content;
}

std::string header() {
  constexpr std::size_t kTextBytes = 124;
  std::string text = "MATLAB 5.0 MAT-file, created by isomatch";
  text.resize(kTextBytes - 8, ' ');
  // No data of subsystems.
  text.append(8, '\0');
  constexpr std::uint16_t kVersion = 0x0100, kByteOrder = 0x4d49;
  for (const std::uint16_t word : {kVersion, kByteOrder})
    text.append(reinterpret_cast<const char*>(&word), sizeof(word));
  return text;
}

}  // namespace

ReadResult read_mat(const InputFile& file) {
  const std::vector<MatVariable> variables = read_mat_variables(file);
  const Arrays arrays = find_shape(file, variables);
  ReadResult result;
  result.mesh.vertices = points_of(file, arrays);
  result.mesh.faces = faces_of(file, arrays, result.mesh.vertices.size());
  return result;
}

void write_mat(const Mesh& mesh, AtomicFile& file) {
  const MatBytes content = surface(mesh);
  if (content.size() > std::numeric_limits<std::uint32_t>::max())
    throw BadFile(file.path(), "the mesh is too large for a MATLAB file of level 5");
  MatBytes tag;
  tag.append_tag(kMatrix, content.size());
  file.write(header());
  file.write(tag.bytes());
  file.write(content.bytes());
}

}  // namespace isomatch::mesh_io
