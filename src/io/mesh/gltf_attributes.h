// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "io/input_file.h"
#include "io/mesh/gltf_accessors.h"
#include "isomatch/io/model_io.h"

namespace isomatch::mesh_io {

/// The vertices of one part of a mesh in the list of all vertices.
struct GltfVertices {
  int first;
  int count;
  /// Which of them, counted from `first`, have their colours and poses from this part.
  std::vector<int> own;
};

/// Colours and poses of the vertices of a glTF file, gathered part by part. Parts without colours
/// are white and parts without poses keep still, as glTF says. A pose of one name is one pose,
/// whatever meshes have it.
class GltfAttributes {
 public:
  /// Keeps references to both.
  GltfAttributes(const InputFile& file, const tinygltf::Model& model,
                 const GltfAccessors& accessors)
      : file_(file), model_(model), accessors_(accessors) {}

  void add_colors(const tinygltf::Primitive& primitive, const GltfVertices& vertices);

  /// `rest` holds all vertices so far, which `to_scene` has moved.
  void add_poses(const tinygltf::Mesh& mesh, const tinygltf::Primitive& primitive,
                 const GltfVertices& vertices, const Eigen::Affine3d& to_scene,
                 const std::vector<Point>& rest);

  /// Of all vertices; empty if there are none.
  VertexColors colors(std::size_t vertices) &&;
  std::vector<Pose> poses(const std::vector<Point>& rest) &&;

 private:
  std::vector<Point>& pose_named(const std::string& name, const std::vector<Point>& rest);

  const InputFile& file_;
  const tinygltf::Model& model_;
  const GltfAccessors& accessors_;
  VertexColors colors_;
  std::vector<Pose> poses_;
  std::map<std::string, std::size_t> pose_of_name_;
};

}  // namespace isomatch::mesh_io
