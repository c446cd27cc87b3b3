// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/io/mesh_io.h"
#include "isomatch/mesh/texture.h"

/// Mesh files with what they look like. What is said in mesh_io.h of vertex order, reports,
/// exceptions and cost holds here too.
namespace isomatch {

/// Reads an .obj file with `vt`, `usemtl` and the corners of its faces. Faces of which a corner has
/// no texture coordinate have none. The name of a material is the rest of its line: blanks within
/// and # belong to it. Throws `BadFile` too if no face has any.
TexturedMesh read_textured_mesh(const std::string& path, MeshReadReport* report = nullptr);

/// The files of materials that an .obj file names, as it names them, each once. A `mtllib` line may
/// name several files, and a name may hold blanks: the line is one name if that file is there,
/// otherwise it is the files that are there, the longest names first; what is left is split behind
/// words that end in ".mtl", and dropped from a # on.
std::vector<std::string> material_libraries(const std::string& path);

/// The path of the file that the mesh or material file `beside` calls `name`, seen from its folder:
/// as it is, without quotes around it, or with backslashes that stand before blanks or for slashes.
/// Empty if there is no such file.
std::string find_named_file(const std::string& name, const std::string& beside);

/// Writes an .obj file that names `libraries` as its files of materials. Line ends in names of
/// materials become blanks. Throws `InvalidInput` if the texture fails `validate`.
void write_textured_mesh(const std::string& path, const TexturedMesh& textured,
                         const std::vector<std::string>& libraries = {});

/// Red, green and blue in [0, 1] of each vertex.
using VertexColors = std::vector<Eigen::Vector3d>;

/// Reads the vertex colours of a .ply file, `red`, `green` and `blue`. Integers are divided by the
/// largest of their type; those of 32 bits by 255 if none is above it. Floating-point numbers are
/// taken as going up to 1 if none is above 1 (by more than rounding), otherwise up to 255,
/// otherwise up to 65535. Throws `BadFile` too if it has none.
VertexColors read_vertex_colors(const std::string& path, MeshReadReport* report = nullptr);

/// Writes a binary .ply file with colours of 8 bits a channel. Throws `InvalidInput` if there are
/// not as many colours as vertices.
void write_colored_mesh(const std::string& path, const Mesh& mesh, const VertexColors& colors);

}  // namespace isomatch
