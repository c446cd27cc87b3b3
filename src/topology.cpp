// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/topology.h"

#include <algorithm>
#include <numeric>

namespace isomatch {
namespace {

/// One side of an edge: its ends in ascending order, the face, and the corner opposite the edge.
struct EdgeSide {
  int low, high, face, corner;

  bool same_edge(const EdgeSide& other) const { return low == other.low && high == other.high; }
  auto operator<=>(const EdgeSide&) const = default;
};

std::vector<EdgeSide> sorted_edge_sides(const Mesh& mesh) {
  std::vector<EdgeSide> sides;
  sides.reserve(mesh.faces.size() * 3);
  for (int f = 0; f < mesh.num_faces(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const auto [low, high] =
          std::minmax(mesh.faces[f][(corner + 1) % 3], mesh.faces[f][(corner + 2) % 3]);
      sides.push_back({low, high, f, corner});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

int find_root(std::vector<int>& parent, int vertex) {
  while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
  return vertex;
}

}  // namespace

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
  const std::vector<EdgeSide> sides = sorted_edge_sides(mesh);
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if_not(
        first, sides.end(), [&](const EdgeSide& side) { return side.same_edge(*first); });
    if (last - first == 2) {
      const EdgeSide &a = first[0], &b = first[1];
      neighbours[a.face][a.corner] = b.face;
      neighbours[b.face][b.corner] = a.face;
    }
    first = last;
  }
  return neighbours;
}

std::vector<int> vertex_components(const Mesh& mesh) {
  std::vector<int> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const Face& face : mesh.faces) {
    for (int corner = 1; corner < 3; ++corner) {
      const int a = find_root(parent, face[0]), b = find_root(parent, face[corner]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  int components = 0;
  std::vector<int> label(mesh.vertices.size());
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const int root = find_root(parent, v);
    label[v] = root == v ? components++ : label[root];
  }
  return label;
}

}  // namespace isomatch
