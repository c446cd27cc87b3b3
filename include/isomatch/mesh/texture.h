// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// What the faces of a mesh are covered with.
struct Texture {
  static constexpr int kNone = -1;

  /// Places in an image, (0, 0) its lower left and (1, 1) its upper right corner.
  std::vector<Eigen::Vector2d> coordinates;
  /// For each face the `coordinates` of its corners; `kNone` for all three where it has none.
  std::vector<std::array<int, 3>> corners;
  /// Names, and for each face which of them it has, `kNone` for none.
  std::vector<std::string> materials;
  std::vector<int> face_material;

  bool covers(int face) const { return corners[face][0] != kNone; }
};

/// Red, green and blue in [0, 1] of each vertex.
using VertexColors = std::vector<Eigen::Vector3d>;

struct TexturedMesh {
  Mesh mesh;
  Texture texture;
};

/// Throws `InvalidInput` unless `texture` has an entry for each face of `mesh`, indices in range,
/// and finite coordinates. O(N).
void validate(const Texture& texture, const Mesh& mesh);

}  // namespace isomatch
