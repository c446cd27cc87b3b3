// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/projection.h"

#include "geometry/closest_point.h"
#include "geometry/interpolation.h"

namespace isomatch::elastic {

Projection::Projection(const Mesh& mesh, const IndexLists& vertex_faces,
                       const std::vector<Point>& normals, const std::vector<Features>& features,
                       const ProjectionWeights& weights, std::span<const int> rim)
    : mesh_(mesh),
      vertex_faces_(vertex_faces),
      normals_(normals),
      nearest_vertex_(mesh.vertices, normals, features, weights),
      on_rim_(mesh.vertices.size(), false) {
  for (int v : rim) on_rim_[v] = true;
}

Foot Projection::operator()(const Point& position, const Point& normal,
                            const Features& features) const {
  return (*this)(position, normal, features, {});
}

Foot Projection::operator()(const Point& position, const Point& normal, const Features& features,
                            const SurfacePoint& earlier) const {
  const int guess = earlier.face == kNoFace ? kNoVertex : heaviest_corner(mesh_, earlier);
  Foot foot;
  foot.point = closest_point_around(mesh_, vertex_faces_,
                                    nearest_vertex_(position, normal, features, guess), position);
  foot.position = isomatch::position(mesh_, foot.point);
  foot.normal = interpolated(mesh_, normals_, foot.point).normalized();
  const Face& face = mesh_.faces[foot.point.face];
  foot.on_rim = true;
  for (int k = 0; k < 3; ++k)
    if (foot.point.weights[k] > 0 && !on_rim_[face[k]]) foot.on_rim = false;
  return foot;
}

}  // namespace isomatch::elastic
