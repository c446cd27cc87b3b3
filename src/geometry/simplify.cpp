// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/simplify.h"

#include <meshoptimizer.h>

#include <algorithm>

namespace isomatch {

std::vector<Face> simplified_faces(const Mesh& mesh, int count) {
  if (mesh.num_vertices() <= count) return mesh.faces;
  using Index = unsigned int;
  std::vector<Index> corners;
  corners.reserve(mesh.faces.size() * 3);
  for (const Face& face : mesh.faces) corners.insert(corners.end(), face.begin(), face.end());
  std::vector<float> positions;
  positions.reserve(mesh.vertices.size() * 3);
  for (const Point& p : mesh.vertices)
    for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(p[k]));
  // A closed surface has twice as many faces as vertices.
  const std::size_t wanted = std::min(static_cast<std::size_t>(count) * 6, corners.size());
  std::vector<Index> kept(corners.size());
  kept.resize(meshopt_simplify(kept.data(), corners.data(), corners.size(), positions.data(),
                               mesh.vertices.size(), 3 * sizeof(float), wanted, 1.0F, 0, nullptr));
  std::vector<Face> faces(kept.size() / 3);
  for (std::size_t c = 0; c < kept.size(); ++c) faces[c / 3][c % 3] = static_cast<int>(kept[c]);
  return faces;
}

SimplifiedMesh without_unused_vertices(const Mesh& mesh) {
  SimplifiedMesh result{{{}, mesh.faces}, {}};
  std::vector<int> number(mesh.vertices.size(), 0);
  for (const Face& face : mesh.faces)
    for (int v : face) number[v] = 1;
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    if (number[v] == 0) continue;
    number[v] = static_cast<int>(result.kept.size());
    result.kept.push_back(v);
    result.mesh.vertices.push_back(mesh.vertices[v]);
  }
  for (Face& face : result.mesh.faces)
    for (int& v : face) v = number[v];
  return result;
}

SimplifiedMesh simplify(const Mesh& mesh, int count) {
  return without_unused_vertices({mesh.vertices, simplified_faces(mesh, count)});
}

}  // namespace isomatch
