// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/mesh_io.h"
#include "isomatch/texture.h"

/// Mesh files with what they look like. What is said in mesh_io.h of vertex order, reports,
/// exceptions and cost holds here too.
namespace isomatch {

/// Reads an .obj file with `vt`, `usemtl` and the corners of its faces. Faces of which a corner has
/// no texture coordinate have none. Throws `BadFile` too if no face has any.
TexturedMesh read_textured_mesh(const std::string& path, MeshReadReport* report = nullptr);

/// The files of materials that an .obj file names, as it names them.
std::vector<std::string> material_libraries(const std::string& path);

/// Writes an .obj file that names `library`, unless empty, as its file of materials. Throws
/// `InvalidInput` if the texture fails `validate`.
void write_textured_mesh(const std::string& path, const TexturedMesh& textured,
                         const std::string& library);

/// Red, green and blue in [0, 1] of each vertex.
using VertexColors = std::vector<Eigen::Vector3d>;

/// Reads the vertex colours of a .ply file (`red`, `green` and `blue`; integers are divided by the
/// largest of their type). Throws `BadFile` too if it has none.
VertexColors read_vertex_colors(const std::string& path, MeshReadReport* report = nullptr);

/// Writes a binary .ply file with colours of 8 bits a channel. Throws `InvalidInput` if there are
/// not as many colours as vertices.
void write_colored_mesh(const std::string& path, const Mesh& mesh, const VertexColors& colors);

}  // namespace isomatch
