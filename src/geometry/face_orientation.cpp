// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/face_orientation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "geometry/hat_gradients.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {

using Sides = std::span<const EdgeSide>;

bool is_ascending(const Mesh& mesh, const EdgeSide& side) {
  return mesh.faces[side.face][(side.corner + 1) % 3] == side.low;
}

bool is_inconsistent(const Mesh& mesh, Sides edge) {
  return edge.size() == 2 && is_ascending(mesh, edge[0]) == is_ascending(mesh, edge[1]);
}

std::vector<Hinge> hinges(const Mesh& mesh) {
  std::vector<Hinge> hinges;
  for_each_edge(sorted_edge_sides(mesh), [&](Sides edge) {
    if (edge.size() != 2) return;
    const Hinge hinge{edge[0].face, edge[1].face, is_inconsistent(mesh, edge) ? -1.0 : 1.0};
    const Point normal = area_vector(mesh.vertices, mesh.faces[hinge.f]);
    if (hinge.sign * normal.dot(area_vector(mesh.vertices, mesh.faces[hinge.g])) > 0)
      hinges.push_back(hinge);
  });
  return hinges;
}

DisjointSets orientation_cover(const Mesh& mesh, Sides sides) {
  DisjointSets cover(2 * mesh.num_faces());
  for_each_edge(sides, [&](Sides edge) {
    if (edge.size() != 2) return;
    const int a = 2 * edge[0].face, b = 2 * edge[1].face;
    const int turn = is_inconsistent(mesh, edge) ? 1 : 0;
    cover.join(a, b + turn);
    cover.join(a + 1, b + 1 - turn);
  });
  return cover;
}

namespace {

using Signs = std::vector<signed char>;

/// Of the area, what must be turned alike in the file. Files with a few turned triangles have more
/// than .99, a random half has about .5.
constexpr double kMinAgreement = 0.8;
/// Length of the boundary relative to sqrt(area) up to which a surface counts as closed: scans lack
/// a foot or the inside of a mouth, while a hemisphere has 2.5, a flat square 4.
constexpr double kMaxBoundary = 0.5;

/// Turns each patch as most of its area is in the file. Returns the area that is turned as in the
/// file less that which is not, or nothing if some patch is one-sided.
std::optional<double> orient_patches(const Mesh& mesh, DisjointSets cover, Signs& signs) {
  std::vector<double> patch_area(mesh.faces.size(), 0.0);
  std::vector<int> patch(mesh.faces.size());
  for (int f = 0; f < mesh.num_faces(); ++f) {
    const int as_it_is = cover.find(2 * f), turned = cover.find(2 * f + 1);
    if (as_it_is == turned) return std::nullopt;
    patch[f] = std::min(as_it_is, turned) / 2;
    signs[f] = as_it_is < turned ? 1 : -1;
    patch_area[patch[f]] += signs[f] * face_area(mesh, f);
  }
  double agreement = 0;
  for (int f = 0; f < mesh.num_faces(); ++f) {
    if (patch_area[patch[f]] < 0) signs[f] = static_cast<signed char>(-signs[f]);
    if (patch[f] == f) agreement += std::abs(patch_area[f]);
  }
  return agreement;
}

double boundary_length(const Mesh& mesh, Sides sides) {
  double length = 0;
  for_each_edge(sides, [&](Sides edge) {
    if (edge.size() == 1)
      length += (mesh.vertices[edge[0].high] - mesh.vertices[edge[0].low]).norm();
  });
  return length;
}

double enclosed_volume(const Mesh& mesh, const Signs& signs) {
  const Point centre = std::accumulate(mesh.vertices.begin(), mesh.vertices.end(), Point(0, 0, 0)) /
                       mesh.num_vertices();
  double volume = 0;
  for (int f = 0; f < mesh.num_faces(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Point p = mesh.vertices[a] - centre, q = mesh.vertices[b] - centre;
    volume += signs[f] * p.dot(q.cross(mesh.vertices[c] - centre)) / 6;
  }
  return volume;
}

}  // namespace

std::optional<std::vector<signed char>> face_orientation(const Mesh& mesh) {
  const std::vector<EdgeSide> sides = sorted_edge_sides(mesh);
  Signs signs(mesh.faces.size());
  const std::optional<double> agreement =
      orient_patches(mesh, orientation_cover(mesh, sides), signs);
  // If the share s of the area is turned as in the file and 1 - s is not, they differ by 2 s - 1.
  const double area = surface_area(mesh);
  if (!agreement || *agreement < (2 * kMinAgreement - 1) * area) return std::nullopt;
  const bool closed = boundary_length(mesh, sides) <= kMaxBoundary * std::sqrt(area);
  if (closed && enclosed_volume(mesh, signs) < 0) {
    for (signed char& sign : signs) sign = static_cast<signed char>(-sign);
  }
  return signs;
}

}  // namespace isomatch
