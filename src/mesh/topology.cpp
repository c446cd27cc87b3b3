// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/topology.h"

#include <algorithm>
#include <numeric>

#include "geometry/bucket_sort.h"
#include "geometry/disjoint_sets.h"

namespace isomatch {

bool has_repeated_vertex(const Face& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

std::vector<EdgeSide> sorted_edge_sides(const Mesh& mesh) {
  return bucket_sorted<EdgeSide>(mesh.num_vertices(), [&](const auto& sink) {
    for (int f = 0; f < mesh.num_faces(); ++f) {
      const Face& face = mesh.faces[f];
      if (has_repeated_vertex(face)) continue;
      for (int corner = 0; corner < 3; ++corner) {
        const auto [low, high] = std::minmax(face[(corner + 1) % 3], face[(corner + 2) % 3]);
        sink(low, EdgeSide{low, high, f, corner});
      }
    }
  });
}

IndexLists vertex_faces(const Mesh& mesh) {
  std::vector<int> offsets(mesh.vertices.size() + 1, 0);
  for (const Face& face : mesh.faces) {
    for (int v : face) ++offsets[v + 1];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<int> values(offsets.back());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for (int f = 0; f < mesh.num_faces(); ++f) {
    for (int v : mesh.faces[f]) values[next[v]++] = f;
  }
  return {std::move(offsets), std::move(values)};
}

std::vector<std::array<int, 3>> face_neighbours(const Mesh& mesh) {
  std::vector<std::array<int, 3>> neighbours(mesh.faces.size(), {kNoFace, kNoFace, kNoFace});
  for_each_edge(sorted_edge_sides(mesh), [&](std::span<const EdgeSide> sides) {
    if (sides.size() != 2) return;
    neighbours[sides[0].face][sides[0].corner] = sides[1].face;
    neighbours[sides[1].face][sides[1].corner] = sides[0].face;
  });
  return neighbours;
}

std::vector<int> vertex_components(const Mesh& mesh) {
  DisjointSets sets(mesh.num_vertices());
  for (const Face& face : mesh.faces) {
    sets.join(face[0], face[1]);
    sets.join(face[0], face[2]);
  }
  int components = 0;
  std::vector<int> label(mesh.vertices.size());
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const int root = sets.find(v);
    label[v] = root == v ? components++ : label[root];
  }
  return label;
}

}  // namespace isomatch
