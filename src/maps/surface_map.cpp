// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/maps/surface_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/interpolation.h"
#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

void check_length(std::size_t length, int vertices) {
  if (std::cmp_not_equal(length, vertices))
    throw InvalidInput(
        fmt::format("the map has {} points, but the mesh {} vertices", length, vertices));
}

}  // namespace

Point position(const Mesh& mesh, const SurfacePoint& point) {
  return interpolated(mesh, mesh.vertices, point);
}

void check_map(const SurfaceMap& map, int from_vertices, int onto_faces) {
  check_length(map.size(), from_vertices);
  for (const SurfacePoint& point : map)
    if (point.face < kNoFace || point.face >= onto_faces)
      throw InvalidInput(
          fmt::format("the map: face {} is out of range; there are {}", point.face, onto_faces));
}

void check_map(const VertexMap& map, int from_vertices, int onto_vertices) {
  check_length(map.size(), from_vertices);
  for (const int vertex : map)
    if (vertex < kUnmatched || vertex >= onto_vertices)
      throw InvalidInput(
          fmt::format("the map: vertex {} is out of range; there are {}", vertex, onto_vertices));
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

int heaviest_corner(const Mesh& mesh, const SurfacePoint& point) {
  return mesh.faces[point.face][std::ranges::max_element(point.weights) - point.weights.begin()];
}

VertexMap nearest_vertices(const Mesh& mesh, const SurfaceMap& map) {
  VertexMap vertices;
  vertices.reserve(map.size());
  for (const SurfacePoint& point : map)
    vertices.push_back(point.face == kNoFace ? kUnmatched : heaviest_corner(mesh, point));
  return vertices;
}

}  // namespace isomatch
