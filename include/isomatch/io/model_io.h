// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/io/mesh_io.h"
#include "isomatch/mesh/mesh.h"
#include "isomatch/mesh/texture.h"

/// Mesh files with all that this library keeps of them. What is said in mesh_io.h of formats,
/// vertex order, exceptions and cost holds here too.
namespace isomatch {

/// Where the vertices of a mesh are in another pose.
struct Pose {
  std::string name;
  std::vector<Point> vertices;
};

/// A mesh, what it looks like, and other poses of it. All but the mesh may be absent, and is empty
/// then: `colors`, `texture.corners`, `poses`.
struct Model {
  Mesh mesh{};
  VertexColors colors{};
  Texture texture{};
  std::vector<Pose> poses{};
};

/// Throws `InvalidInput` if the mesh or the texture fails its own `validate`, there are colours,
/// but not one for each vertex, or a pose has another number of vertices or a coordinate that is
/// not finite. O(N).
void validate(const Model& model);

/// Reads a mesh file of any format, reports to `report` unless it is null, and what it has of:
/// - colours: .ply, and .glb and .gltf (converted from linear intensities to sRGB). In .ply files,
///   integers are divided by the largest of their type; those of 32 bits by 255 if none is above
///   it. Floating-point numbers are taken as going up to 1 if none is above 1 (by more than
///   rounding), otherwise up to 255, otherwise up to 65535;
/// - texture coordinates and names of materials: .obj, .glb, .gltf (those that the texture of the
///   base colour uses, moved as KHR_texture_transform says). Of an .obj file, faces of which a
///   corner has no texture coordinate have none, and the name of a material is the rest of its
///   line: blanks within and # belong to it;
/// - poses: morph targets of .glb and .gltf, one for each name.
/// Where some parts of a glTF file have no colours, they are white; where they have no poses, they
/// keep still.
Model read_model(const std::string& path, MeshReadReport* report = nullptr,
                 const MeshReadOptions& options = {});

/// Reads an .obj file with texture coordinates. Throws `BadFile` too if no face has any, or the
/// ending is another one.
TexturedMesh read_textured_mesh(const std::string& path, MeshReadReport* report = nullptr);

/// Reads the colours of a .ply file, which needs no faces. Throws `BadFile` too if it has none, or
/// the ending is another one.
VertexColors read_vertex_colors(const std::string& path, MeshReadReport* report = nullptr);

struct ModelWriteOptions {
  /// .obj only: the files of materials that it names, if the model has a texture.
  std::vector<std::string> material_libraries{};
};

/// Writes a mesh file of any format that can be written, and what the format has room for:
/// - .ply: colours, in 8 bits a channel;
/// - .obj: texture coordinates and names of materials, in which line ends become blanks, but not
///   the files of materials;
/// - .glb, .gltf: colours, texture coordinates, and a morph target for each pose. A vertex with
///   several texture coordinates keeps its number for the first of them; each other one gets a copy
///   of the vertex after all vertices of the mesh. Normals are added.
/// The file appears whole or not at all. Throws `InvalidInput` if `model` fails `validate`.
void write_model(const std::string& path, const Model& model,
                 const ModelWriteOptions& options = {});

}  // namespace isomatch
