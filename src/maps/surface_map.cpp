// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/maps/surface_map.h"

#include <algorithm>

#include "geometry/kd_tree.h"
#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

/// Surface face of each input face up to the last that is part of the surface, `kNoFace` if none.
std::vector<int> surface_faces(const Surface& surface) {
  std::vector<int> faces(std::ranges::max(surface.input_face) + 1, kNoFace);
  for (int f = 0; f < surface.mesh.num_faces(); ++f) faces[surface.input_face[f]] = f;
  return faces;
}

}  // namespace

Point position(const Mesh& mesh, const SurfacePoint& point) {
  const Face& face = mesh.faces[point.face];
  Point sum(0, 0, 0);
  for (int k = 0; k < 3; ++k) sum += point.weights[k] * mesh.vertices[face[k]];
  return sum;
}

SurfaceMap corner_points(const Mesh& mesh) {
  SurfaceMap points(mesh.vertices.size());
  for (int f = 0; f < mesh.num_faces(); ++f) {
    for (int k = 0; k < 3; ++k) {
      SurfacePoint& point = points[mesh.faces[f][k]];
      if (point.face != kNoFace) continue;
      point.face = f;
      point.weights[k] = 1;
    }
  }
  return points;
}

SurfaceMap corner_points(const Mesh& target, const VertexMap& source_to_target) {
  const SurfaceMap vertices = corner_points(target);
  SurfaceMap points(source_to_target.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    if (source_to_target[v] != kUnmatched) points[v] = vertices[source_to_target[v]];
  return points;
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

SurfaceMap surface_map(const Surface& source, const Surface& target, const SurfaceMap& input_map) {
  if (input_map.size() != source.surface_vertex.size())
    throw InvalidInput("the map's length is not the source's number of vertices");
  const std::vector<int> surface_face = surface_faces(target);
  SurfaceMap result(source.num_vertices());
  for (std::size_t v = 0; v < result.size(); ++v) {
    const SurfacePoint& point = input_map[source.input_vertex[v]];
    if (point.face < kNoFace) throw InvalidInput("the map has a negative face");
    if (point.face == kNoFace || std::cmp_greater_equal(point.face, surface_face.size())) continue;
    const int face = surface_face[point.face];
    if (face != kNoFace) result[v] = {face, point.weights};
  }
  return result;
}

Mesh input_pose(const Mesh& input, const Surface& surface, const std::vector<Point>& positions) {
  if (input.vertices.size() != surface.surface_vertex.size() ||
      positions.size() != surface.mesh.vertices.size())
    throw InvalidInput("input_pose needs the mesh of the surface and a position for every vertex");
  const KdTree<3> tree(surface.mesh.vertices);
  Mesh result = input;
  for (int v = 0; v < input.num_vertices(); ++v) {
    const int own = surface.surface_vertex[v];
    const int leader = own != kNoVertex ? own : tree.nearest(input.vertices[v]);
    result.vertices[v] =
        own != kNoVertex
            ? positions[own]
            : Point(input.vertices[v] + positions[leader] - surface.mesh.vertices[leader]);
  }
  return result;
}

}  // namespace isomatch
