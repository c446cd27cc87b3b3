// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "support/zoo.h"

#include <algorithm>
#include <utility>

#include "support/shapes.h"
#include "support/transforms.h"

namespace isomatch::test {
namespace {

constexpr int kSubdivisions = 2;

Mesh sphere_at(const Point& centre, double radius) {
  Mesh mesh = icosphere(kSubdivisions, radius);
  for (Point& p : mesh.vertices) p += centre;
  return mesh;
}

void replace_vertex(Mesh& mesh, int old_vertex, int new_vertex) {
  for (Face& face : mesh.faces) std::ranges::replace(face, old_vertex, new_vertex);
}

}  // namespace

Mesh sphere_with_hole() {
  Mesh mesh = icosphere(kSubdivisions);
  mesh.faces.erase(mesh.faces.begin());
  return mesh;
}

Mesh sphere_with_fin() {
  Mesh mesh = icosphere(kSubdivisions);
  const auto [a, b, c] = mesh.faces[0];
  mesh.faces.push_back({a, b, mesh.num_vertices()});
  mesh.vertices.push_back(1.5 * mesh.vertices[a]);
  return mesh;
}

Mesh bow_tie() {
  const Mesh large = icosphere(kSubdivisions);
  Mesh mesh = combined(large, sphere_at(1.5 * large.vertices[0], 0.5));
  const int opposite = large.num_vertices() + 3;  // vertices 0 and 3 of an icosahedron are opposite
  const int last = mesh.num_vertices() - 1;
  replace_vertex(mesh, opposite, 0);
  replace_vertex(mesh, last, opposite);
  mesh.vertices[opposite] = mesh.vertices[last];
  mesh.vertices.pop_back();
  return mesh;
}

Mesh three_spheres() {
  return combined(combined(sphere_at(Point(5, 0, 0), 0.25), sphere_at(Point(0, 0, 0), 1)),
                  sphere_at(Point(0, 5, 0), 0.5));
}

Mesh sphere_with_degenerate_faces() {
  Mesh mesh = icosphere(kSubdivisions);
  const int middle = mesh.num_vertices();
  mesh.vertices.push_back((mesh.vertices[0] + mesh.vertices[1]) / 2);
  for (double t : {1.0, 2.0, 4.0}) mesh.vertices.push_back(t * Point(0.1, 0.3, 0.7));
  mesh.faces.insert(mesh.faces.end(),
                    {{0, 0, 1}, {2, 2, 2}, {0, 1, middle}, {middle + 1, middle + 2, middle + 3}});
  return mesh;
}

Mesh sphere_with_duplicate_faces() {
  Mesh mesh = icosphere(kSubdivisions);
  const auto [a, b, c] = mesh.faces[6];
  const auto [d, e, f] = mesh.faces[7];
  const Face equal = mesh.faces[5];
  mesh.faces.insert(mesh.faces.end(), {equal, {b, c, a}, {e, d, f}});
  return mesh;
}

Mesh sphere_with_unreferenced_vertices() {
  Mesh mesh = icosphere(kSubdivisions);
  mesh.vertices.insert(mesh.vertices.begin(), {Point(7, 7, 7), Point(8, 8, 8)});
  mesh.vertices.insert(mesh.vertices.end(), {Point(9, 0, 0), Point(0, 9, 0), Point(0, 0, 9)});
  for (Face& face : mesh.faces) {
    for (int& v : face) v += 2;
  }
  return mesh;
}

Mesh sphere_with_flipped_faces() {
  Mesh mesh = icosphere(kSubdivisions);
  for (int f = 0; f < mesh.num_faces(); f += 10) std::swap(mesh.faces[f][0], mesh.faces[f][1]);
  return mesh;
}

Mesh sphere_of_charts() {
  const Mesh mesh = icosphere(kSubdivisions);
  return split_charts(mesh, octants(mesh));
}

Mesh two_sided_sheet() {
  const Mesh front = sheet(4, 4);
  Mesh back = front;
  for (Face& face : back.faces) std::swap(face[1], face[2]);
  return combined(front, back);
}

Mesh three_sheets_on_a_line() {
  Mesh upright = sheet(4, 4), left = sheet(4, 4);
  for (Point& p : upright.vertices) p = Point(0, p.y(), p.x());
  for (Point& p : left.vertices) p.x() = -p.x();
  return combined(combined(sheet(4, 4), upright), left);
}

Mesh sheets_touching_in_a_point() {
  Mesh other = sheet(4, 4, 0.5, 0.5);
  for (Point& p : other.vertices) p += Point(1, 1, 0);
  return combined(sheet(4, 4), other);
}

std::vector<ZooMesh> mesh_zoo() {
  return {{"sphere", icosphere(kSubdivisions)},
          {"rough_sphere", rough_sphere(kSubdivisions, 0.2, 1)},
          {"box", box(4)},
          {"torus", torus(24, 12)},
          {"sheet", sheet(6, 4)},
          {"open_cylinder", open_cylinder(16, 8)},
          {"closed_cylinder", closed_cylinder(16, 8)},
          {"moebius_strip", moebius_strip(24)},
          {"uv_sphere", uv_sphere(16, 8)},
          {"sphere_with_hole", sphere_with_hole()},
          {"sphere_with_fin", sphere_with_fin()},
          {"bow_tie", bow_tie()},
          {"three_spheres", three_spheres()},
          {"sphere_with_degenerate_faces", sphere_with_degenerate_faces()},
          {"sphere_with_duplicate_faces", sphere_with_duplicate_faces()},
          {"sphere_with_unreferenced_vertices", sphere_with_unreferenced_vertices()},
          {"sphere_with_flipped_faces", sphere_with_flipped_faces()},
          {"sphere_of_charts", sphere_of_charts()},
          {"sphere_soup", soup(icosphere(kSubdivisions))},
          {"two_sided_sheet", two_sided_sheet()},
          {"three_sheets_on_a_line", three_sheets_on_a_line()},
          {"sheets_touching_in_a_point", sheets_touching_in_a_point()}};
}

}  // namespace isomatch::test
