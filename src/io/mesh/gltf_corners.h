// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isomatch/io/model_io.h"

namespace isomatch::mesh_io {

/// A model as glTF wants it: one texture coordinate a vertex.
struct SplitVertices {
  /// Of each vertex that of the model: all of them in order, then copies of those that have several
  /// texture coordinates.
  std::vector<int> original;
  /// Of each vertex; empty if the model has none.
  std::vector<Eigen::Vector2d> coordinates;
  std::vector<Face> faces;
};

/// A corner without texture coordinate takes its vertex's first one. O(N log N).
SplitVertices split_vertices(const Model& model);

}  // namespace isomatch::mesh_io
