// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "exact_geodesics.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <limits>
#include <stdexcept>

namespace isomatch::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, SurfaceMesh>;
using ShortestPaths = CGAL::Surface_mesh_shortest_path<Traits>;
using Vertex = SurfaceMesh::Vertex_index;

SurfaceMesh surface_mesh(const Mesh& mesh) {
  SurfaceMesh result;
  for (const Point& p : mesh.vertices) result.add_vertex({p.x(), p.y(), p.z()});
  for (const auto& [a, b, c] : mesh.faces) {
    if (result.add_face(Vertex(a), Vertex(b), Vertex(c)) == SurfaceMesh::null_face())
      throw std::invalid_argument("the mesh is not manifold and oriented");
  }
  return result;
}

}  // namespace

std::vector<double> exact_distances(const Mesh& mesh, int source) {
  const SurfaceMesh surface = surface_mesh(mesh);
  ShortestPaths paths(surface);
  paths.add_source_point(Vertex(source));
  std::vector<double> distances;
  for (const Vertex v : surface.vertices()) {
    const double distance =
        surface.is_isolated(v) ? -1 : paths.shortest_distance_to_source_points(v).first;
    distances.push_back(distance < 0 ? std::numeric_limits<double>::infinity() : distance);
  }
  return distances;
}

}  // namespace isomatch::test
