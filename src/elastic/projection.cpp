// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/projection.h"

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
  return foot_around(nearest_vertex_(position, normal, features), position, mesh_, vertex_faces_,
                     normals_);
}

}  // namespace isomatch::elastic
