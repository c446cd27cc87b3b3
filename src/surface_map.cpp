// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/surface_map.h"

#include <algorithm>

#include "isomatch/topology.h"

namespace isomatch {

Point position(const Mesh& mesh, const SurfacePoint& point) {
  const Face& face = mesh.faces[point.face];
  Point sum(0, 0, 0);
  for (int k = 0; k < 3; ++k) sum += point.weights[k] * mesh.vertices[face[k]];
  return sum;
}

VertexMap nearest_vertices(const Mesh& mesh, const SurfaceMap& map) {
  VertexMap vertices;
  vertices.reserve(map.size());
  for (const SurfacePoint& point : map) {
    const auto corner = std::ranges::max_element(point.weights) - point.weights.begin();
    vertices.push_back(point.face == kNoFace ? kUnmatched : mesh.faces[point.face][corner]);
  }
  return vertices;
}

SurfaceMap input_map(const Surface& source, const Surface& target, const SurfaceMap& map) {
  SurfaceMap result(source.surface_vertex.size());
  for (std::size_t v = 0; v < result.size(); ++v) {
    const int vertex = source.surface_vertex[v];
    if (vertex == kNoVertex || map[vertex].face == kNoFace) continue;
    result[v] = {target.input_face[map[vertex].face], map[vertex].weights};
  }
  return result;
}

}  // namespace isomatch
