// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <optional>

#include "input_file.h"

namespace isomatch::mesh_io {

/// The content of a .glb or .gltf file with its buffers: the one inside of a .glb, data URIs, and
/// files beside it. Images are not looked at. Throws `BadFile` if it is malformed, not of version
/// 2, or needs an extension that changes what the numbers mean.
tinygltf::Model load_gltf(const InputFile& file);

/// A mesh in a scene, and where the scene puts it.
struct PlacedMesh {
  const tinygltf::Mesh* mesh;
  Eigen::Affine3d transform;
};

/// The mesh of the first node that has one, depth first from the roots of the scene that is shown;
/// failing that, the first mesh as it is. Throws `BadFile` if there is none or nodes are nested in
/// a circle.
PlacedMesh first_mesh(const InputFile& file, const tinygltf::Model& model);

}  // namespace isomatch::mesh_io
