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

void write_model(const std::string& path, const Model& model) {
  check_mesh_output(path);
  validate(model);
  if (const Write write = gltf_writer_of(path)) {
    AtomicFile file(path);
    write(model, file);
    file.commit();
  } else if (ends_with(path, ".ply") && !model.colors.empty()) {
    write_colored_mesh(path, model.mesh, model.colors);
  } else if (ends_with(path, ".obj") && !model.texture.corners.empty()) {
    write_textured_mesh(path, {model.mesh, model.texture});
  } else {
    write_mesh(path, model.mesh);
  }
}

}  // namespace isomatch
