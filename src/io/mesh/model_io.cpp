// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/model_io.h"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>
#include <utility>

#include "io/mesh/formats.h"
#include "io/text_cursor.h"
#include "isomatch/error.h"

namespace isomatch {
namespace {

bool ends_with(const std::string& path, std::string_view ending) {
  return equal_ignoring_case(std::filesystem::path(path).extension().string(), ending);
}

using Read = mesh_io::ReadResult (*)(const InputFile&, const MeshReadOptions&);
using Write = void (*)(const Model&, AtomicFile&);

/// Null for formats that have a mesh and nothing else.
Read reader_of(const std::string& path) {
  if (ends_with(path, ".obj")) return mesh_io::read_only_mesh<mesh_io::read_textured_obj>;
  if (ends_with(path, ".ply")) return mesh_io::read_only_mesh<mesh_io::read_colored_ply>;
  if (ends_with(path, ".glb") || ends_with(path, ".gltf")) return mesh_io::read_gltf_model;
  return nullptr;
}

Write gltf_writer_of(const std::string& path) {
  if (ends_with(path, ".glb")) return mesh_io::write_glb_model;
  if (ends_with(path, ".gltf")) return mesh_io::write_gltf_model;
  return nullptr;
}

void check_ending(const std::string& path, std::string_view ending) {
  if (!ends_with(path, ending))
    throw BadFile(path, fmt::format("must be a file named {} here", ending));
}

/// Without texture if it covers nothing.
void drop_empty_texture(Model& model) {
  for (std::size_t f = 0; f < model.texture.corners.size(); ++f)
    if (model.texture.covers(static_cast<int>(f))) return;
  model.texture = {};
}

}  // namespace

void validate(const Model& model) {
  validate(model.mesh);
  if (!model.texture.corners.empty()) validate(model.texture, model.mesh);
  const std::size_t vertices = model.mesh.vertices.size();
  if (!model.colors.empty() && model.colors.size() != vertices)
    throw InvalidInput("a model needs a colour for every vertex or none");
  for (const Pose& pose : model.poses) {
    if (pose.vertices.size() != vertices)
      throw InvalidInput(
          fmt::format("pose {} does not have as many vertices as the mesh", in_quotes(pose.name)));
  }
}

Model read_model(const std::string& path, MeshReadReport* report, const MeshReadOptions& options) {
  const Read read = reader_of(path);
  if (!read) return {read_mesh(path, report, options), {}, {}, {}};
  const InputFile file(path);
  mesh_io::ReadResult result = read(file, options);
  mesh_io::complete(result, file);
  if (report) *report = std::move(result.report);
  Model model{std::move(result.mesh), std::move(result.colors), std::move(result.texture),
              std::move(result.poses)};
  drop_empty_texture(model);
  return model;
}

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

VertexColors read_vertex_colors(const std::string& path, MeshReadReport* report) {
  const InputFile file(path);
  check_ending(path, ".ply");
  mesh_io::ReadResult result = mesh_io::read_colored_ply(file);
  if (result.colors.empty()) file.fail("its vertices have no colours: red, green and blue");
  if (report) *report = std::move(result.report);
  return std::move(result.colors);
}

void write_model(const std::string& path, const Model& model, const ModelWriteOptions& options) {
  check_mesh_output(path);
  validate(model);
  const Write write_gltf = gltf_writer_of(path);
  const bool is_colored = ends_with(path, ".ply") && !model.colors.empty();
  const bool is_textured = ends_with(path, ".obj") && !model.texture.corners.empty();
  if (!write_gltf && !is_colored && !is_textured) return write_mesh(path, model.mesh);
  AtomicFile file(path);
  if (write_gltf)
    write_gltf(model, file);
  else if (is_colored)
    mesh_io::write_colored_ply(model.mesh, model.colors, file);
  else
    mesh_io::write_textured_obj(model, options.material_libraries, file);
  file.commit();
}

}  // namespace isomatch
