// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/mesh.h"

#include <fmt/format.h>

#include "geometry/hat_gradients.h"
#include "isomatch/error.h"

namespace isomatch {

void validate(const Mesh& mesh) {
  if (mesh.vertices.empty()) throw InvalidInput("the mesh has no vertices");
  if (mesh.faces.empty()) throw InvalidInput("the mesh has no faces");
  for (int f = 0; f < mesh.num_faces(); ++f) {
    for (int v : mesh.faces[f]) {
      if (v < 0 || v >= mesh.num_vertices())
        throw InvalidInput(fmt::format("face {} names vertex {}, but there are {} vertices", f, v,
                                       mesh.num_vertices()));
    }
  }
}

void validate_finite(const Mesh& mesh) {
  validate(mesh);
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    if (!mesh.vertices[v].allFinite())
      throw InvalidInput(fmt::format("vertex {} has a coordinate that is not finite", v));
  }
}

double face_area(const Mesh& mesh, int face) {
  return 0.5 * area_vector(mesh.vertices, mesh.faces[face]).norm();
}

double surface_area(const Mesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.num_faces(); ++f) sum += face_area(mesh, f);
  return sum;
}

std::vector<double> vertex_areas(const Mesh& mesh) {
  std::vector<double> areas(mesh.vertices.size(), 0.0);
  for (int f = 0; f < mesh.num_faces(); ++f) {
    const double third = face_area(mesh, f) / 3;
    for (int v : mesh.faces[f]) areas[v] += third;
  }
  return areas;
}

std::vector<Point> weighted_vertex_normals(const Mesh& mesh) {
  std::vector<Point> normals(mesh.vertices.size(), Point::Zero());
  for (const Face& face : mesh.faces) {
    const Point normal = area_vector(mesh.vertices, face);
    for (int v : face) normals[v] += normal;
  }
  return normals;
}

}  // namespace isomatch
