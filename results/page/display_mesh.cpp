// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/display_mesh.h"

#include <meshoptimizer.h>

#include <algorithm>

#include "geometry/kd_tree.h"
#include "geometry/simplify.h"

namespace isomatch::results {
namespace {

constexpr int kHidden = -1;

std::vector<float> float_positions(const Mesh& mesh) {
  std::vector<float> positions;
  positions.reserve(mesh.vertices.size() * 3);
  for (const Point& p : mesh.vertices)
    for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(p[k]));
  return positions;
}

/// All vertices, or those of `faces`, along a space-filling curve.
std::vector<int> shown_vertices(const std::vector<float>& positions, const std::vector<Face>& faces,
                                bool all) {
  const std::size_t count = positions.size() / 3;
  std::vector<unsigned int> place(count);
  meshopt_spatialSortRemap(place.data(), positions.data(), count, 3 * sizeof(float));
  std::vector<int> order(count);
  for (std::size_t v = 0; v < count; ++v) order[place[v]] = static_cast<int>(v);
  if (all) return order;
  std::vector<bool> used(count);
  for (const Face& face : faces)
    for (int v : face) used[v] = true;
  std::erase_if(order, [&](int v) { return !used[v]; });
  return order;
}

void sort_faces(std::vector<Face>& faces) {
  for (Face& face : faces) std::ranges::rotate(face, std::ranges::min_element(face));
  std::ranges::sort(faces);
}

/// Gives vertices that are not shown to the nearest one that is.
void represent_hidden(const Mesh& mesh, DisplayMesh& display) {
  const KdTree<3> tree(display.mesh.vertices);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (display.shown_vertex[v] == kHidden)
      display.shown_vertex[v] = tree.nearest(mesh.vertices[v]);
  }
}

}  // namespace

DisplayMesh display_mesh(const Mesh& mesh, int max_vertices) {
  DisplayMesh display;
  display.simplified = mesh.num_vertices() > max_vertices;
  const std::vector<float> positions = float_positions(mesh);
  const std::vector<Face> faces = simplified_faces(mesh, max_vertices);
  display.input_vertex = shown_vertices(positions, faces, !display.simplified);
  display.shown_vertex.assign(mesh.vertices.size(), kHidden);
  for (std::size_t shown = 0; shown < display.input_vertex.size(); ++shown) {
    display.shown_vertex[display.input_vertex[shown]] = static_cast<int>(shown);
    display.mesh.vertices.push_back(mesh.vertices[display.input_vertex[shown]]);
  }
  for (const Face& face : faces)
    display.mesh.faces.push_back({display.shown_vertex[face[0]], display.shown_vertex[face[1]],
                                  display.shown_vertex[face[2]]});
  sort_faces(display.mesh.faces);
  if (display.simplified) represent_hidden(mesh, display);
  return display;
}

}  // namespace isomatch::results
