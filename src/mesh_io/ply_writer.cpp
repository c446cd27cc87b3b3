// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <string_view>

#include "mesh_io/formats.h"

namespace isomatch::mesh_io {
namespace {

constexpr std::string_view kHeader =
    "ply\n"
    "format binary_little_endian 1.0\n"
    "element vertex {}\n"
    "property double x\n"
    "property double y\n"
    "property double z\n"
    "element face {}\n"
    "property list uchar int vertex_indices\n"
    "end_header\n";
constexpr char kCorners = 3;

template <class T>
void append_little_endian(std::string& bytes, T value) {
  auto part = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(part.begin(), part.end());
  bytes.append(part.data(), part.size());
}

}  // namespace

void write_ply(const Mesh& mesh, AtomicFile& file) {
  file.write(fmt::format(kHeader, mesh.num_vertices(), mesh.num_faces()));
  std::string bytes;
  for (const Point& point : mesh.vertices) {
    bytes.clear();
    for (const double coordinate : point) append_little_endian(bytes, coordinate);
    file.write(bytes);
  }
  for (const Face& face : mesh.faces) {
    bytes.assign(1, kCorners);
    for (const int vertex : face) append_little_endian(bytes, vertex);
    file.write(bytes);
  }
}

}  // namespace isomatch::mesh_io
