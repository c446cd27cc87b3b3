// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/descent.h"

namespace isomatch::elastic {

/// Squared.
double Descent::distance(int vertex, const Coordinates& query) const {
  const Coordinates there =
      coordinates(mesh_.vertices[vertex], normals_[vertex], features_[vertex], weights_);
  double sum = 0;
  for (std::size_t k = 0; k < query.size(); ++k)
    sum += (there[k] - query[k]) * (there[k] - query[k]);
  return sum;
}

int Descent::nearest_vertex(int start, const Point& position, const Point& normal,
                            const Features& features) const {
  const Coordinates query = coordinates(position, normal, features, weights_);
  int best = start, at = -1;
  double least = distance(start, query);
  while (best != at) {
    at = best;
    for (int f : vertex_faces_[at]) {
      for (int v : mesh_.faces[f]) {
        if (v == at) continue;
        const double reached = distance(v, query);
        if (reached >= least) continue;
        least = reached;
        best = v;
      }
    }
  }
  return best;
}

Foot Descent::operator()(int start, const Point& position, const Point& normal,
                         const Features& features) const {
  return foot_around(nearest_vertex(start, position, normal, features), position, mesh_,
                     vertex_faces_, normals_);
}

}  // namespace isomatch::elastic
