// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "load.h"

#include <fmt/format.h>

#include <utility>

#include "isomatch/error.h"
#include "progress_bar.h"

namespace isomatch::cli {
namespace {

/// What `read(path, report)` reads.
template <class Read>
auto loaded(const std::string& path, const Read& read) {
  MeshReadReport report;
  auto result = read(path, &report);
  for (const std::string& warning : report.warnings) warn(path, warning);
  return result;
}

/// `work()` on what was read from `path`, which is to blame.
template <class Work>
auto of_file(const std::string& path, const Work& work) {
  try {
    return work();
  } catch (const InvalidInput& error) {
    throw BadFile(path, error.what());
  }
}

}  // namespace

void warn(const std::string& path, std::string_view warning) {
  warn(fmt::format("{}: {}", path, warning));
}

void warn(std::string_view warning) {
  ProgressBar::make_room();
  fmt::print(stderr, "warning: {}\n", warning);
}

Mesh load_mesh(const std::string& path) {
  return loaded(path, [](const auto&... arguments) { return read_mesh(arguments...); });
}

Model load_model(const std::string& path, const MeshReadOptions& options) {
  return loaded(path, [&](const auto&... arguments) { return read_model(arguments..., options); });
}

TexturedMesh load_textured_mesh(const std::string& path) {
  return loaded(path, read_textured_mesh);
}

VertexColors load_vertex_colors(const std::string& path) {
  return loaded(path, read_vertex_colors);
}

void add_mesh_option(CLI::App& command, MeshReadOptions& options) {
  command
      .add_option("--mesh", options.mesh,
                  "Of a glTF file only this mesh, by its name; without this all of the scene")
      ->type_name("NAME");
}

MeshDiagnosis diagnosed(const std::string& path, const Mesh& mesh) {
  return of_file(path, [&] { return diagnose(mesh); });
}

Inspection inspected(const std::string& path, const Mesh& mesh) {
  return of_file(path, [&] {
    Inspection inspection = inspect(mesh);
    if (!inspection.surface) throw InvalidInput("the mesh has no face of positive area");
    return inspection;
  });
}

Shape prepare_loaded(const std::string& path, const Mesh& mesh, const Context& context) {
  return of_file(path, [&] { return prepare_shape(mesh, {}, context); });
}

Shape load_shape(const std::string& path, const Context& context) {
  return prepare_loaded(path, load_mesh(path), context);
}

}  // namespace isomatch::cli
