// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/mesh.h"

namespace isomatch {

/// Lists of integers, one per index, stored in one block (compressed sparse rows).
class IndexLists {
 public:
  IndexLists() = default;
  /// `offsets` has one more entry than there are lists; list i is `values[offsets[i],
  /// offsets[i+1])`.
  IndexLists(std::vector<int> offsets, std::vector<int> values)
      : offsets_(std::move(offsets)), values_(std::move(values)) {}

  int size() const { return static_cast<int>(offsets_.size()) - 1; }
  std::span<const int> operator[](int index) const {
    return {values_.data() + offsets_[index], values_.data() + offsets_[index + 1]};
  }

 private:
  std::vector<int> offsets_{0};
  std::vector<int> values_;
};

/// The faces around each vertex, in ascending order. O(N).
IndexLists vertex_faces(const Mesh& mesh);

/// For each face, the face across the edge opposite corner 0, 1 and 2. `kNoFace` where the edge is
/// a boundary or belongs to more than two faces. Orientation plays no part. O(N log N).
inline constexpr int kNoFace = -1;
std::vector<std::array<int, 3>> face_neighbours(const Mesh& mesh);

/// Component label of each vertex, numbered from 0 in the order of their lowest vertex. Vertices
/// are connected if they share a face; an unreferenced vertex is a component of its own. O(N).
std::vector<int> vertex_components(const Mesh& mesh);

}  // namespace isomatch
