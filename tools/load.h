// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "isomatch/io/model_io.h"
#include "isomatch/mesh/diagnosis.h"
#include "isomatch/mesh/shape.h"

namespace isomatch::cli {

/// Tells on standard error, `--quiet` or not, what is odd about the file `path`.
void warn(const std::string& path, std::string_view warning);
/// The same of what is not a file's fault.
void warn(std::string_view warning);

/// The readers of the same names with `read` for `load`. They tell what the reader warns of.
Mesh load_mesh(const std::string& path);
Model load_model(const std::string& path, const MeshReadOptions& options = {});
TexturedMesh load_textured_mesh(const std::string& path);
VertexColors load_vertex_colors(const std::string& path);

/// Adds `--mesh`, which chooses a mesh of a glTF file.
void add_mesh_option(CLI::App& command, MeshReadOptions& options);

/// `diagnose` of a mesh that was read from `path`.
MeshDiagnosis diagnosed(const std::string& path, const Mesh& mesh);

/// Diagnosis and surface, of which there is one, of a mesh that was read from `path`. What makes it
/// unusable is a `BadFile`.
Inspection inspected(const std::string& path, const Mesh& mesh);

/// `prepare_shape` of a mesh that was read from `path`. What makes it unusable is a `BadFile`.
Shape prepare_loaded(const std::string& path, const Mesh& mesh, const Context& context);

/// Reads a mesh and prepares it. What makes it unusable is a `BadFile` that names `path`.
Shape load_shape(const std::string& path, const Context& context);

}  // namespace isomatch::cli
