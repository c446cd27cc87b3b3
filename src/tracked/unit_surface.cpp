// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/unit_surface.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/face_orientation.h"

namespace isomatch::tracked {

UnitSurface unit_surface(const Surface& surface, bool mirrored) {
  UnitSurface unit;
  Mesh& mesh = unit.mesh;
  mesh = surface.mesh;
  unit.faces = vertex_faces(mesh);
  unit.scale = std::sqrt(surface.area);
  unit.centre = std::accumulate(mesh.vertices.begin(), mesh.vertices.end(), Point(0, 0, 0)) /
                mesh.num_vertices();
  for (Point& p : mesh.vertices) {
    p = (p - unit.centre) / unit.scale;
    if (mirrored) p[0] = -p[0];
  }
  const auto signs = face_orientation(mesh);
  unit.oriented = signs.has_value();
  unit.turned.assign(mesh.faces.size(), false);
  for (int f = 0; unit.oriented && f < mesh.num_faces(); ++f) {
    unit.turned[f] = (*signs)[f] < 0;
    if (unit.turned[f]) std::swap(mesh.faces[f][1], mesh.faces[f][2]);
  }
  unit.normals = unit_normals(mesh);
  return unit;
}

std::vector<Point> unit_normals(const Mesh& mesh) {
  std::vector<Point> normals = weighted_vertex_normals(mesh);
  for (Point& normal : normals) normal.normalize();
  return normals;
}

}  // namespace isomatch::tracked
