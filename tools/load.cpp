// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "load.h"

#include <fmt/format.h>

#include "program/progress_bar.h"

namespace isomatch::cli {
namespace {

/// What `read(path, report)` reads.
template <class Read>
auto loaded(const std::string& path, const Read& read) {
  MeshReadReport report;
  auto result = read(path, &report);
  for (const std::string& warning : report.warnings) warn_of(path, warning);
  return result;
}

}  // namespace

void warn_of(const std::string& path, std::string_view warning) {
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

}  // namespace isomatch::cli
