// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "group/template_map.h"

#include <algorithm>
#include <array>

#include "elastic/projection.h"
#include "geometry/walk.h"
#include "isomatch/mesh/topology.h"
#include "parallel.h"
#include "shape/boundary.h"

namespace isomatch::group {
namespace {

/// The template as it lies on a shape: without the vertices that the shape does not have.
struct LaidOn {
  Mesh mesh;
  /// Of the template for each face.
  std::vector<int> template_face;
};

LaidOn laid_on(const Surface& template_surface, const std::vector<Point>& registered,
               const SurfaceMap& places) {
  const std::vector<Face>& faces = template_surface.mesh.faces;
  LaidOn laid;
  std::vector<int> number(places.size(), kNoVertex);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (std::ranges::any_of(faces[f], [&](int v) { return places[v].face == kNoFace; })) continue;
    for (int& v : laid.mesh.faces.emplace_back(faces[f])) {
      if (number[v] == kNoVertex) {
        number[v] = laid.mesh.num_vertices();
        laid.mesh.vertices.push_back(registered[v]);
      }
      v = number[v];
    }
    laid.template_face.push_back(static_cast<int>(f));
  }
  return laid;
}

}  // namespace

SurfaceMap map_to_template(const Surface& template_surface, const Surface& shape,
                           const std::vector<Point>& registered, const SurfaceMap& places,
                           const Context& context) {
  constexpr double kReach = 0.03;  // Over sqrt(area): what is farther from the rim lies beyond it.
  // Both surfaces all but coincide: normals need only tell the sides of thin parts apart.
  constexpr elastic::ProjectionWeights kWeights{.normal = 0.01, .relief = 0, .place = 0};
  SurfaceMap map(shape.mesh.vertices.size());
  const LaidOn laid = laid_on(template_surface, registered, places);
  if (laid.mesh.faces.empty()) return map;
  const IndexLists around = vertex_faces(laid.mesh);
  const std::vector<Point> normals = unit_normals(laid.mesh);
  const std::vector<elastic::Features> features(laid.mesh.vertices.size());
  const elastic::Projection onto(laid.mesh, around, normals, features, kWeights,
                                 boundary_vertices(laid.mesh));
  parallel_for(std::ssize(map), context, [&](std::ptrdiff_t v) {
    const Point& vertex = shape.mesh.vertices[v];
    const elastic::Foot foot = onto(vertex, shape.normals[v], {});
    if (foot.on_rim && (foot.position - vertex).norm() > kReach) return;
    const SurfacePoint closest =
        walk_to_point(laid.mesh, around, std::array{foot.point.face}, vertex);
    map[v] = {laid.template_face[closest.face], closest.weights};
  });
  return map;
}

}  // namespace isomatch::group
