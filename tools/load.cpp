// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "load.h"

#include <fmt/format.h>

#include <utility>

#include "isomatch/error.h"
#include "progress_bar.h"

namespace isomatch::cli {
namespace {

/// What `read` reads from `path`.
template <class Result>
Result loaded(const std::string& path, Result (*read)(const std::string&, MeshReadReport*)) {
  MeshReadReport report;
  Result result = read(path, &report);
  for (const std::string& warning : report.warnings) warn(path, warning);
  return result;
}

}  // namespace

void warn(const std::string& path, std::string_view warning) {
  ProgressBar::clear_line();
  fmt::print(stderr, "warning: {}: {}\n", path, warning);
}

Mesh load_mesh(const std::string& path) { return loaded(path, read_mesh); }
Model load_model(const std::string& path) { return loaded(path, read_model); }
TexturedMesh load_textured_mesh(const std::string& path) {
  return loaded(path, read_textured_mesh);
}
VertexColors load_vertex_colors(const std::string& path) {
  return loaded(path, read_vertex_colors);
}

Inspection inspected(const std::string& path, const Mesh& mesh) {
  try {
    Inspection inspection = inspect(mesh);
    if (!inspection.surface) throw InvalidInput("the mesh has no face of positive area");
    return inspection;
  } catch (const InvalidInput& error) {
    throw BadFile(path, error.what());
  }
}

Shape prepare_loaded(const std::string& path, const Mesh& mesh, const Context& context) {
  try {
    return prepare_shape(mesh, {}, context);
  } catch (const InvalidInput& error) {
    throw BadFile(path, error.what());
  }
}

Shape load_shape(const std::string& path, const Context& context) {
  return prepare_loaded(path, load_mesh(path), context);
}

}  // namespace isomatch::cli
