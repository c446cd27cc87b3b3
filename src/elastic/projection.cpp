// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/projection.h"

#include "geometry/closest_point.h"

namespace isomatch::elastic {

Projection::Projection(const Mesh& mesh, const IndexLists& vertex_faces,
                       const std::vector<Point>& normals, const std::vector<Features>& features,
                       const ProjectionWeights& weights)
    : mesh_(mesh),
      vertex_faces_(vertex_faces),
      normals_(normals),
      nearest_vertex_(mesh.vertices, normals, features, weights) {}

Foot Projection::operator()(const Point& position, const Point& normal,
                            const Features& features) const {
  Foot foot;
  foot.point = closest_point_around(mesh_, vertex_faces_,
                                    nearest_vertex_(position, normal, features), position);
  foot.position = isomatch::position(mesh_, foot.point);
  const Face& face = mesh_.faces[foot.point.face];
  for (int k = 0; k < 3; ++k) foot.normal += foot.point.weights[k] * normals_[face[k]];
  foot.normal.normalize();
  return foot;
}

}  // namespace isomatch::elastic
