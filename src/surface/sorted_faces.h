// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <algorithm>
#include <compare>
#include <vector>

#include "bucket_sort.h"
#include "isomatch/mesh.h"

namespace isomatch {

/// A face by its vertices in ascending order.
struct SortedFace {
  Face vertices;
  int face;

  auto operator<=>(const SortedFace&) const = default;
};

/// The faces of `mesh` in ascending order of their sorted vertices, then of their index.
inline std::vector<SortedFace> sorted_faces(const Mesh& mesh) {
  return bucket_sorted<SortedFace>(mesh.num_vertices(), [&](const auto& sink) {
    for (int f = 0; f < mesh.num_faces(); ++f) {
      Face vertices = mesh.faces[f];
      std::ranges::sort(vertices);
      sink(vertices[0], SortedFace{vertices, f});
    }
  });
}

}  // namespace isomatch
