// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "isomatch/io/model_io.h"

namespace isomatch::cli {

/// Tells on standard error, `--quiet` or not, what is odd about the file `path`.
void warn_of(const std::string& path, std::string_view warning);
/// The same of what is not a file's fault.
void warn(std::string_view warning);

/// The readers of the same names with `read` for `load`. They tell what the reader warns of.
Mesh load_mesh(const std::string& path);
Model load_model(const std::string& path, const MeshReadOptions& options = {});
TexturedMesh load_textured_mesh(const std::string& path);
VertexColors load_vertex_colors(const std::string& path);

/// Adds `--mesh`, which chooses a mesh of a glTF file.
void add_mesh_option(CLI::App& command, MeshReadOptions& options);

}  // namespace isomatch::cli
