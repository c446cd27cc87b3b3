// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/simplify.h"

#include <meshoptimizer.h>

#include <algorithm>

namespace isomatch::tracked {
namespace {

using Index = unsigned int;

/// Corners of the faces of `mesh` with about `count` of its vertices.
std::vector<Index> simplified(const Mesh& mesh, int count) {
  std::vector<Index> indices;
  indices.reserve(mesh.faces.size() * 3);
  for (const Face& face : mesh.faces) indices.insert(indices.end(), face.begin(), face.end());
  if (mesh.num_vertices() <= count) return indices;
  std::vector<float> positions;
  positions.reserve(mesh.vertices.size() * 3);
  for (const Point& p : mesh.vertices)
    for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(p[k]));
  std::vector<Index> result(indices.size());
  const std::size_t target = std::min(static_cast<std::size_t>(count) * 6, indices.size());
  result.resize(meshopt_simplify(result.data(), indices.data(), indices.size(), positions.data(),
                                 mesh.vertices.size(), 3 * sizeof(float), target, 1.0F, 0,
                                 nullptr));
  return result;
}

}  // namespace

SimplifiedMesh simplify(const Mesh& mesh, int count) {
  const std::vector<Index> corners = simplified(mesh, count);
  std::vector<int> number(mesh.vertices.size(), 0);
  for (Index v : corners) number[v] = 1;
  SimplifiedMesh result;
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    if (number[v] == 0) continue;
    number[v] = static_cast<int>(result.kept.size());
    result.kept.push_back(v);
    result.mesh.vertices.push_back(mesh.vertices[v]);
  }
  for (std::size_t c = 0; c < corners.size(); c += 3)
    result.mesh.faces.push_back(
        {number[corners[c]], number[corners[c + 1]], number[corners[c + 2]]});
  return result;
}

}  // namespace isomatch::tracked
