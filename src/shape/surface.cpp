// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/surface.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/face_orientation.h"

namespace isomatch {
namespace {

void scale_to_unit_area(double area, Surface& surface) {
  Mesh& mesh = surface.mesh;
  surface.area = area;
  surface.scale = std::sqrt(area);
  surface.centre = std::accumulate(mesh.vertices.begin(), mesh.vertices.end(), Point(0, 0, 0)) /
                   mesh.num_vertices();
  for (Point& p : mesh.vertices) p = (p - surface.centre) / surface.scale;
}

void turn(Face& face) { std::swap(face[1], face[2]); }

void turn_outwards(Surface& surface) {
  Mesh& mesh = surface.mesh;
  const auto signs = face_orientation(mesh);
  surface.oriented = signs.has_value();
  surface.turned.assign(mesh.faces.size(), false);
  for (int f = 0; surface.oriented && f < mesh.num_faces(); ++f) {
    surface.turned[f] = (*signs)[f] < 0;
    if (surface.turned[f]) turn(mesh.faces[f]);
  }
}

/// The inverse of `surface_vertex`.
IndexLists input_vertices(const std::vector<int>& surface_vertex, int count) {
  std::vector<int> offsets(count + 1, 0);
  for (int v : surface_vertex)
    if (v != kNoVertex) ++offsets[v + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<int> values(offsets.back()), next = offsets;
  for (std::size_t i = 0; i < surface_vertex.size(); ++i)
    if (surface_vertex[i] != kNoVertex) values[next[surface_vertex[i]]++] = static_cast<int>(i);
  return {std::move(offsets), std::move(values)};
}

}  // namespace

Surface unit_surface(ExtractedSurface extracted) {
  Surface surface;
  surface.mesh = std::move(extracted.mesh);
  surface.faces = vertex_faces(surface.mesh);
  scale_to_unit_area(extracted.area, surface);
  turn_outwards(surface);
  surface.normals = unit_normals(surface.mesh);
  surface.vertex_areas = vertex_areas(surface.mesh);
  surface.input_vertex = std::move(extracted.input_vertex);
  surface.surface_vertex = std::move(extracted.surface_vertex);
  surface.input_face = std::move(extracted.input_face);
  surface.num_input_faces = extracted.num_input_faces;
  surface.input_vertices = input_vertices(surface.surface_vertex, surface.num_vertices());
  return surface;
}

Surface mirror_image(Surface surface) {
  for (Point& p : surface.mesh.vertices) p[0] = -p[0];
  for (Face& face : surface.mesh.faces) turn(face);
  surface.turned.flip();
  for (Point& normal : surface.normals) normal[0] = -normal[0];
  return surface;
}

Surface scaled(Surface surface, double size) {
  for (Point& p : surface.mesh.vertices) p *= size;
  for (double& area : surface.vertex_areas) area *= size * size;
  surface.scale /= size;
  return surface;
}

std::vector<Point> unit_normals(const Mesh& mesh) {
  std::vector<Point> normals = weighted_vertex_normals(mesh);
  for (Point& normal : normals) normal.normalize();
  return normals;
}

}  // namespace isomatch
