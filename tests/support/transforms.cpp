// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "support/transforms.h"

#include <algorithm>
#include <map>
#include <utility>

namespace isomatch::test {

Mesh moved(const Mesh& mesh, Random& random) {
  double size = 0;
  for (const Point& p : mesh.vertices) size = std::max(size, p.norm());
  const Eigen::Matrix3d rotation = random.rotation();
  const Point translation = 10 * size * random.direction();
  Mesh result = mesh;
  for (Point& p : result.vertices) p = rotation * p + translation;
  return result;
}

Mesh scaled(const Mesh& mesh, double factor) {
  Mesh result = mesh;
  for (Point& p : result.vertices) p *= factor;
  return result;
}

Mesh rounded_to_float(Mesh mesh) {
  for (Point& p : mesh.vertices)
    for (double& c : p) c = static_cast<float>(c);
  return mesh;
}

Mesh mirrored(const Mesh& mesh) {
  Mesh result = mesh;
  for (Point& p : result.vertices) p.x() = -p.x();
  for (Face& face : result.faces) std::swap(face[1], face[2]);
  return result;
}

Relabelled relabelled(const Mesh& mesh, Random& random) {
  Relabelled result{mesh, random.permutation(mesh.num_vertices()),
                    random.permutation(mesh.num_faces())};
  for (int v = 0; v < mesh.num_vertices(); ++v)
    result.mesh.vertices[result.new_vertex[v]] = mesh.vertices[v];
  for (int f = 0; f < mesh.num_faces(); ++f) {
    Face& face = result.mesh.faces[result.new_face[f]];
    for (int corner = 0; corner < 3; ++corner)
      face[corner] = result.new_vertex[mesh.faces[f][corner]];
    std::rotate(face.begin(), face.begin() + random.index(3), face.end());
  }
  return result;
}

Mesh combined(const Mesh& a, const Mesh& b) {
  Mesh result = a;
  result.vertices.insert(result.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [u, v, w] : b.faces)
    result.faces.push_back({u + a.num_vertices(), v + a.num_vertices(), w + a.num_vertices()});
  return result;
}

Mesh soup(const Mesh& mesh) {
  Mesh result;
  for (const Face& face : mesh.faces) {
    const int first = result.num_vertices();
    for (int v : face) result.vertices.push_back(mesh.vertices[v]);
    result.faces.push_back({first, first + 1, first + 2});
  }
  return result;
}

Mesh split_charts(const Mesh& mesh, const std::vector<int>& chart) {
  Mesh result = mesh;
  std::vector<bool> taken(mesh.vertices.size(), false);
  std::map<std::pair<int, int>, int> copy;  // vertex and chart to the vertex that stands for it
  for (int f = 0; f < mesh.num_faces(); ++f) {
    for (int& v : result.faces[f]) {
      const auto [place, is_new] = copy.try_emplace({v, chart[f]}, v);
      if (is_new && taken[v]) {
        place->second = result.num_vertices();
        result.vertices.push_back(mesh.vertices[v]);
      }
      taken[v] = true;
      v = place->second;
    }
  }
  return result;
}

std::vector<int> octants(const Mesh& mesh) {
  std::vector<int> octant;
  for (const auto& [a, b, c] : mesh.faces) {
    const Point sum = mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c];
    octant.push_back((sum.x() > 0 ? 1 : 0) + (sum.y() > 0 ? 2 : 0) + (sum.z() > 0 ? 4 : 0));
  }
  return octant;
}

}  // namespace isomatch::test
