// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "io/input_file.h"
#include "io/mesh/gltf_accessors.h"
#include "isomatch/mesh/texture.h"

namespace isomatch::mesh_io {

/// The texture coordinates of a glTF file: those that the texture of a part's material uses (its
/// base colour's, failing that any), moved by KHR_texture_transform, and turned upside down, as
/// glTF counts from the upper left corner of an image.
class GltfCoordinates {
 public:
  /// Keeps references to all.
  GltfCoordinates(const InputFile& file, const tinygltf::Model& model,
                  const GltfAccessors& accessors)
      : file_(file), model_(model), accessors_(accessors) {}

  /// Appends the coordinates of the vertices of `primitive`, of which there are `vertices`, to
  /// `texture`, unless an earlier part had the same. Returns the index of the first vertex's, or
  /// `Texture::kNone`. Throws `BadFile`.
  int add(const tinygltf::Primitive& primitive, Eigen::Index vertices, Texture& texture);

 private:
  /// Rows of the 2 x 3 matrix of an affine transform.
  using Transform = std::array<double, 6>;

  Transform transform_of(const tinygltf::Primitive& primitive, int& set) const;

  const InputFile& file_;
  const tinygltf::Model& model_;
  const GltfAccessors& accessors_;
  /// Of each accessor and how it was moved.
  std::map<std::pair<int, Transform>, int> first_;
};

}  // namespace isomatch::mesh_io
