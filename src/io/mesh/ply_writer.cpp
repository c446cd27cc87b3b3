// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <string_view>

#include "io/byte_order.h"
#include "io/mesh/formats.h"

namespace isomatch::mesh_io {
namespace {

constexpr std::string_view kHeader =
    "ply\n"
    "format binary_little_endian 1.0\n"
    "element vertex {}\n"
    "property double x\n"
    "property double y\n"
    "property double z\n"
    "{}"
    "element face {}\n"
    "property list uchar int vertex_indices\n"
    "end_header\n";
constexpr std::string_view kColorProperties =
    "property uchar red\n"
    "property uchar green\n"
    "property uchar blue\n";
constexpr char kCorners = 3;

char byte(double intensity) {
  return static_cast<char>(std::lround(255 * std::clamp(intensity, 0.0, 1.0)));
}

/// `colors` is empty or has one for each vertex.
void write(const Mesh& mesh, const VertexColors& colors, AtomicFile& file) {
  file.write(fmt::format(kHeader, mesh.num_vertices(), colors.empty() ? "" : kColorProperties,
                         mesh.num_faces()));
  std::string bytes;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    bytes.clear();
    for (const double coordinate : mesh.vertices[v]) append_little_endian(coordinate, bytes);
    if (!colors.empty())
      for (const double intensity : colors[v]) bytes += byte(intensity);
    file.write(bytes);
  }
  for (const Face& face : mesh.faces) {
    bytes.assign(1, kCorners);
    for (const int vertex : face) append_little_endian(vertex, bytes);
    file.write(bytes);
  }
}

}  // namespace

void write_ply(const Mesh& mesh, AtomicFile& file) { write(mesh, {}, file); }

void write_colored_ply(const Mesh& mesh, const VertexColors& colors, AtomicFile& file) {
  write(mesh, colors, file);
}

}  // namespace isomatch::mesh_io
