// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "elastic/foot.h"
#include "elastic/nearest_point.h"

namespace isomatch::elastic {

/// Finds points of a mesh that are close in position, normal and features, going from vertex to
/// vertex as long as that comes closer. Needs a start in the neighbourhood, and no index.
class Descent {
 public:
  /// Keeps references.
  Descent(const Mesh& mesh, const IndexLists& vertex_faces, const std::vector<Point>& normals,
          const std::vector<Features>& features, const ProjectionWeights& weights)
      : mesh_(mesh),
        vertex_faces_(vertex_faces),
        normals_(normals),
        features_(features),
        weights_(weights) {}

  /// A vertex that is closer than its neighbours, reached from `start`.
  int nearest_vertex(int start, const Point& position, const Point& normal,
                     const Features& features) const;
  /// The closest point on the faces around that vertex.
  Foot operator()(int start, const Point& position, const Point& normal,
                  const Features& features) const;

 private:
  double distance(int vertex, const Coordinates& query) const;

  const Mesh& mesh_;
  const IndexLists& vertex_faces_;
  const std::vector<Point>& normals_;
  const std::vector<Features>& features_;
  ProjectionWeights weights_;
};

}  // namespace isomatch::elastic
