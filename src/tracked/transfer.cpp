// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/transfer.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "face_orientation.h"

namespace isomatch::tracked {

UnitSurface unit_surface(const Shape& shape) {
  UnitSurface surface;
  surface.mesh = shape.surface.mesh;
  surface.faces = vertex_faces(surface.mesh);
  surface.scale = std::sqrt(shape.surface.area);
  Mesh& mesh = surface.mesh;
  surface.centre = std::accumulate(mesh.vertices.begin(), mesh.vertices.end(), Point(0, 0, 0)) /
                   mesh.num_vertices();
  for (Point& p : mesh.vertices) p = (p - surface.centre) / surface.scale;
  const auto signs = face_orientation(mesh);
  surface.oriented = signs.has_value();
  for (int f = 0; surface.oriented && f < mesh.num_faces(); ++f)
    if ((*signs)[f] < 0) std::swap(mesh.faces[f][1], mesh.faces[f][2]);
  surface.normals.assign(mesh.vertices.size(), Point::Zero());
  for (const Face& face : mesh.faces) {
    const Point& p = mesh.vertices[face[0]];
    const Point normal = (mesh.vertices[face[1]] - p).cross(mesh.vertices[face[2]] - p);
    for (int v : face) surface.normals[v] += normal;
  }
  for (Point& normal : surface.normals) normal.normalize();
  return surface;
}

DeformedSurface transfer(const Shape& shape, const UnitSurface& surface, const Proxy& proxy,
                         const elastic::Deformation& deformation) {
  std::vector<int> sources(deformation.size());
  for (std::size_t i = 0; i < sources.size(); ++i)
    sources[i] = proxy.surface_vertex[proxy.nodes[i]];
  const std::vector<int> nearest = GeodesicSearch(shape.graph).nearest_source(sources).nearest;
  DeformedSurface result{std::vector<Point>(nearest.size()), std::vector<Point>(nearest.size())};
  for (std::size_t v = 0; v < nearest.size(); ++v) {
    const Point& p = surface.mesh.vertices[v];
    std::vector<int> nodes{nearest[v]};
    for (int j : deformation.neighbours()[nearest[v]]) nodes.push_back(j);
    double reach = 0;
    for (int j : nodes) reach = std::max(reach, (p - deformation.rest()[j]).norm());
    double total = 0;
    Point position(0, 0, 0), normal(0, 0, 0);
    for (int j : nodes) {
      const Point offset = p - deformation.rest()[j];
      const double share = 1 - offset.norm() / (1.01 * reach + 1e-12);
      const double weight = share * share;
      total += weight;
      position += weight * (deformation.rotations()[j] * offset + deformation.positions()[j]);
      normal += weight * (deformation.rotations()[j] * surface.normals[v]);
    }
    result.positions[v] = position / total;
    result.normals[v] = normal.normalized();
  }
  return result;
}

}  // namespace isomatch::tracked
