// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/io/mesh_io.h"
#include "isomatch/io/texture_io.h"
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
  Mesh mesh;
  VertexColors colors;
  Texture texture;
  std::vector<Pose> poses;
};

/// Throws `InvalidInput` if the mesh or the texture fails its own `validate`, there are colours,
/// but not one for each vertex, or a pose has another number of vertices or a coordinate that is
/// not finite. O(N).
void validate(const Model& model);

/// Reads a mesh file of any format, reports to `report` unless it is null, and what it has of:
/// - colours: .ply, and .glb and .gltf (converted from linear intensities to sRGB);
/// - texture coordinates and names of materials: .obj, .glb, .gltf (those that the texture of the
///   base colour uses, moved as KHR_texture_transform says);
/// - poses: morph targets of .glb and .gltf, one for each name.
/// Where some parts of a glTF file have no colours, they are white; where they have no poses, they
/// keep still.
Model read_model(const std::string& path, MeshReadReport* report = nullptr,
                 const MeshReadOptions& options = {});

/// Writes a mesh file of any format that can be written, and what the format has room for:
/// - .ply: colours;
/// - .obj: texture coordinates and names of materials, without a file of materials;
/// - .glb, .gltf: colours, texture coordinates, and a morph target for each pose. A vertex with
///   several texture coordinates keeps its number for the first of them; each other one gets a copy
///   of the vertex after all vertices of the mesh. Normals are added.
/// The file appears whole or not at all. Throws `InvalidInput` if `model` fails `validate`.
void write_model(const std::string& path, const Model& model);

}  // namespace isomatch
