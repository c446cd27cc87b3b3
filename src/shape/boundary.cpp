// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/boundary.h"

#include <algorithm>
#include <span>

#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

/// Calls `visit(a, b)` for the ends of each edge that has one face.
template <class Visit>
void for_each_boundary_edge(const Mesh& mesh, const Visit& visit) {
  for_each_edge(sorted_edge_sides(mesh), [&](std::span<const EdgeSide> sides) {
    if (sides.size() == 1) visit(sides[0].low, sides[0].high);
  });
}

}  // namespace

std::vector<int> boundary_vertices(const Mesh& mesh) {
  std::vector<int> vertices;
  for_each_boundary_edge(mesh, [&](int a, int b) {
    vertices.push_back(a);
    vertices.push_back(b);
  });
  std::ranges::sort(vertices);
  const auto repeated = std::ranges::unique(vertices);
  vertices.erase(repeated.begin(), repeated.end());
  return vertices;
}

double boundary_length(const Mesh& mesh) {
  double length = 0;
  for_each_boundary_edge(
      mesh, [&](int a, int b) { length += (mesh.vertices[a] - mesh.vertices[b]).norm(); });
  return length;
}

}  // namespace isomatch
