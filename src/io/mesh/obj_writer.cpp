// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <string>
#include <vector>

#include "io/line_writer.h"
#include "io/mesh/formats.h"
#include "io/mesh/text_writer.h"

namespace isomatch::mesh_io {
namespace {

/// A name from another format, as one that ends with its line.
std::string on_one_line(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  // At the end of a line it would join it with the next one.
  if (name.ends_with('\\')) name += ' ';
  return name;
}

void write_faces(const Model& model, LineWriter& lines) {
  const Texture& texture = model.texture;
  int material = Texture::kNone;
  for (int f = 0; f < model.mesh.num_faces(); ++f) {
    if (texture.face_material[f] != material) {
      material = texture.face_material[f];
      // A format without a word for "none" gets a name that no library defines.
      lines.add("usemtl {}",
                material == Texture::kNone ? "none" : on_one_line(texture.materials[material]));
    }
    const auto& [a, b, c] = model.mesh.faces[f];
    const auto& [u, v, w] = texture.corners[f];
    if (texture.covers(f))
      lines.add("f {}/{} {}/{} {}/{}", a + 1, u + 1, b + 1, v + 1, c + 1, w + 1);
    else
      lines.add("f {} {} {}", a + 1, b + 1, c + 1);
  }
}

}  // namespace

void write_obj(const Mesh& mesh, AtomicFile& file) {
  write_text(mesh, {.before_vertex = "v ", .before_face = "f ", .first_index = 1}, file);
}

void write_textured_obj(const Model& model, const std::vector<std::string>& libraries,
                        AtomicFile& file) {
  LineWriter lines(file);
  for (const std::string& library : libraries) lines.add("mtllib {}", library);
  for (const Point& p : model.mesh.vertices) lines.add("v {} {} {}", p.x(), p.y(), p.z());
  for (const auto& uv : model.texture.coordinates) lines.add("vt {} {}", uv.x(), uv.y());
  write_faces(model, lines);
}

}  // namespace isomatch::mesh_io
