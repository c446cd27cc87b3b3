// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "io/input_file.h"

namespace isomatch::mesh_io {

/// A mesh in a scene, and where the scene puts it.
struct PlacedMesh {
  const tinygltf::Mesh* mesh;
  Eigen::Affine3d transform;
  /// The node's, as programs show it; failing that, the mesh's, or mesh_ and its number.
  std::string name;
};

/// The meshes of the scene that is shown, depth first from its roots, each as often as a node shows
/// it; failing that, all meshes as they are. Throws `BadFile` if there is none or a node has two
/// parents.
std::vector<PlacedMesh> placed_meshes(const InputFile& file, const tinygltf::Model& model);

/// Those that are called `name`, or whose mesh is. Throws `BadFile` that lists the names if there
/// is none.
std::vector<PlacedMesh> named_meshes(const InputFile& file, const std::vector<PlacedMesh>& placed,
                                     const std::string& name);

/// Names of `meshes` for a message; only the first of many.
std::string listed_names(const std::vector<PlacedMesh>& meshes);

/// The meshes that are not among `placed`.
std::vector<PlacedMesh> meshes_outside(const tinygltf::Model& model,
                                       const std::vector<PlacedMesh>& placed);

}  // namespace isomatch::mesh_io
