// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/connectivity.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "geometry/face_orientation.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

using Sides = std::span<const EdgeSide>;

/// The corners, numbered 3 face + corner, at the lower and the higher end of the edge.
std::array<int, 2> end_corners(const Mesh& mesh, const EdgeSide& side) {
  const int next = 3 * side.face + (side.corner + 1) % 3;
  const int last = 3 * side.face + (side.corner + 2) % 3;
  return is_ascending(mesh, side) ? std::array{next, last} : std::array{last, next};
}

void count_edges(const Mesh& mesh, Sides sides, Connectivity& counts) {
  for_each_edge(sides, [&](Sides edge) {
    ++counts.edges;
    counts.boundary_edges += edge.size() == 1;
    counts.nonmanifold_edges += edge.size() > 2;
    counts.inconsistent_edges += is_inconsistent(mesh, edge);
  });
}

/// The corners around each vertex, united where their faces share an edge there: a set is a fan.
DisjointSets corner_fans(const Mesh& mesh, Sides sides) {
  DisjointSets fans(3 * mesh.num_faces());
  for_each_edge(sides, [&](Sides edge) {
    const auto [low, high] = end_corners(mesh, edge[0]);
    for (const EdgeSide& side : edge.subspan(1)) {
      const auto [other_low, other_high] = end_corners(mesh, side);
      fans.join(low, other_low);
      fans.join(high, other_high);
    }
  });
  return fans;
}

void count_vertices(const Mesh& mesh, DisjointSets& fans, Connectivity& counts) {
  std::vector<int> fans_of_vertex(mesh.vertices.size(), 0);
  for (int f = 0; f < mesh.num_faces(); ++f) {
    if (has_repeated_vertex(mesh.faces[f])) continue;
    ++counts.faces;
    for (int corner = 0; corner < 3; ++corner)
      fans_of_vertex[mesh.faces[f][corner]] += fans.find(3 * f + corner) == 3 * f + corner;
  }
  for (int number : fans_of_vertex) {
    counts.vertices += number > 0;
    counts.nonmanifold_vertices += number > 1;
  }
}

/// A border goes on through the fans at its vertices.
int count_boundary_loops(const Mesh& mesh, Sides sides, DisjointSets fans) {
  std::vector<int> corners;
  for_each_edge(sides, [&](Sides edge) {
    if (edge.size() != 1) return;
    const auto [low, high] = end_corners(mesh, edge[0]);
    fans.join(low, high);
    corners.push_back(low);
  });
  for (int& corner : corners) corner = fans.find(corner);
  std::ranges::sort(corners);
  return static_cast<int>(std::unique(corners.begin(), corners.end()) - corners.begin());
}

int count_components(const Mesh& mesh) {
  DisjointSets parts(mesh.num_vertices());
  std::vector<char> used(mesh.vertices.size(), 0);
  for (const Face& face : mesh.faces) {
    if (has_repeated_vertex(face)) continue;
    parts.join(face[0], face[1]);
    parts.join(face[0], face[2]);
    for (int v : face) used[v] = 1;
  }
  int components = 0;
  for (int v = 0; v < mesh.num_vertices(); ++v) components += used[v] && parts.find(v) == v;
  return components;
}

bool is_orientable(const Mesh& mesh, Sides sides) {
  DisjointSets cover = orientation_cover(mesh, sides);
  for (int f = 0; f < mesh.num_faces(); ++f) {
    if (cover.find(2 * f) == cover.find(2 * f + 1)) return false;
  }
  return true;
}

}  // namespace

std::optional<int> Connectivity::genus() const {
  if (components != 1 || !orientable || nonmanifold_edges > 0 || nonmanifold_vertices > 0)
    return std::nullopt;
  return (2 - euler_characteristic() - boundary_loops) / 2;
}

Connectivity connectivity(const Mesh& mesh) {
  const std::vector<EdgeSide> sides = sorted_edge_sides(mesh);
  DisjointSets fans = corner_fans(mesh, sides);
  Connectivity counts;
  count_edges(mesh, sides, counts);
  count_vertices(mesh, fans, counts);
  counts.components = count_components(mesh);
  counts.boundary_loops = count_boundary_loops(mesh, sides, std::move(fans));
  counts.orientable = counts.inconsistent_edges == 0 || is_orientable(mesh, sides);
  return counts;
}

}  // namespace isomatch
