// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/texture_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/line_file.h"
#include "io/mesh/formats.h"
#include "io/text_cursor.h"
#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"

namespace isomatch {
namespace {

void check_ending(const std::string& path, std::string_view ending) {
  if (!equal_ignoring_case(std::filesystem::path(path).extension().string(), ending))
    throw BadFile(path, fmt::format("must be a file named {} here", ending));
}

/// A name from another format, as one that ends with its line.
std::string on_one_line(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  // At the end of a line it would join it with the next one.
  if (name.ends_with('\\')) name += ' ';
  return name;
}

void write_faces(LineFile& file, const TexturedMesh& textured) {
  const Texture& texture = textured.texture;
  int material = Texture::kNone;
  for (int f = 0; f < textured.mesh.num_faces(); ++f) {
    if (texture.face_material[f] != material) {
      material = texture.face_material[f];
      // A format without a word for "none" gets a name that no library defines.
      file.add("usemtl {}",
               material == Texture::kNone ? "none" : on_one_line(texture.materials[material]));
    }
    const auto& [a, b, c] = textured.mesh.faces[f];
    const auto& [u, v, w] = texture.corners[f];
    if (texture.covers(f))
      file.add("f {}/{} {}/{} {}/{}", a + 1, u + 1, b + 1, v + 1, c + 1, w + 1);
    else
      file.add("f {} {} {}", a + 1, b + 1, c + 1);
  }
}

}  // namespace

TexturedMesh read_textured_mesh(const std::string& path, MeshReadReport* report) {
  const InputFile file(path);
  check_ending(path, ".obj");
  mesh_io::ReadResult result = mesh_io::read_textured_obj(file);
  mesh_io::complete(result, file);
  if (report) *report = std::move(result.report);
  TexturedMesh textured{std::move(result.mesh), std::move(result.texture)};
  for (int f = 0; f < textured.mesh.num_faces(); ++f)
    if (textured.texture.covers(f)) return textured;
  file.fail("no face has texture coordinates");
}

void write_textured_mesh(const std::string& path, const TexturedMesh& textured,
                         const std::vector<std::string>& libraries) {
  check_ending(path, ".obj");
  validate(textured.mesh);
  validate(textured.texture, textured.mesh);
  LineFile file(path);
  for (const std::string& library : libraries) file.add("mtllib {}", library);
  for (const Point& p : textured.mesh.vertices) file.add("v {} {} {}", p.x(), p.y(), p.z());
  for (const auto& uv : textured.texture.coordinates) file.add("vt {} {}", uv.x(), uv.y());
  write_faces(file, textured);
  file.commit();
}

VertexColors read_vertex_colors(const std::string& path, MeshReadReport* report) {
  const InputFile file(path);
  check_ending(path, ".ply");
  mesh_io::ReadResult result = mesh_io::read_colored_ply(file);
  if (result.colors.empty()) file.fail("its vertices have no colours: red, green and blue");
  if (report) *report = std::move(result.report);
  return std::move(result.colors);
}

void write_colored_mesh(const std::string& path, const Mesh& mesh, const VertexColors& colors) {
  check_ending(path, ".ply");
  validate(mesh);
  if (colors.size() != mesh.vertices.size())
    throw InvalidInput("write_colored_mesh needs a colour for every vertex");
  AtomicFile file(path);
  mesh_io::write_colored_ply(mesh, colors, file);
  file.commit();
}

}  // namespace isomatch
