// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/descent.h"

namespace isomatch::elastic {

int descend(int start, const Point& position, const Mesh& mesh, const IndexLists& vertex_faces) {
  int best = start, at = -1;
  double least = (mesh.vertices[start] - position).squaredNorm();
  while (best != at) {
    at = best;
    for (int f : vertex_faces[at]) {
      for (int v : mesh.faces[f]) {
        const double distance = (mesh.vertices[v] - position).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = v;
      }
    }
  }
  return best;
}

}  // namespace isomatch::elastic
