// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/remains.h"

#include <algorithm>

#include "isomatch/maps/correspondence.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::synth {
namespace {

/// Removes the faces around vertices in which parts touch: on what was a closed manifold, those of
/// more than two open edges. Ends because each round removes faces.
void remove_pinches(Mesh& mesh) {
  std::size_t removed = 1;
  while (removed > 0) {
    const std::vector<int> open = open_edges(mesh);
    removed = std::erase_if(mesh.faces, [&](const Face& face) {
      return std::ranges::any_of(face, [&](int v) { return open[v] > 2; });
    });
  }
}

/// The label of the component of largest area, the lowest of equal ones.
int largest_component(const Mesh& mesh, const std::vector<int>& labels) {
  std::vector<double> areas(labels.size());
  for (int f = 0; f < mesh.num_faces(); ++f) areas[labels[mesh.faces[f][0]]] += face_area(mesh, f);
  return static_cast<int>(std::ranges::max_element(areas) - areas.begin());
}

/// For each vertex its number among those that have a face, `kUnmatched` for the others.
std::vector<int> compact_numbers(const Mesh& mesh) {
  std::vector<int> numbers(mesh.vertices.size(), kUnmatched);
  for (const Face& face : mesh.faces) {
    for (int v : face) numbers[v] = 0;
  }
  int count = 0;
  for (int& number : numbers) {
    if (number != kUnmatched) number = count++;
  }
  return numbers;
}

/// The entries of the vertices that have a number, in order.
std::vector<Point> numbered(const std::vector<Point>& points, const std::vector<int>& numbers) {
  std::vector<Point> result;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (numbers[v] != kUnmatched) result.push_back(points[v]);
  }
  return result;
}

}  // namespace

std::vector<int> open_edges(const Mesh& mesh) {
  std::vector<int> count(mesh.vertices.size());
  for_each_edge(sorted_edge_sides(mesh), [&](std::span<const EdgeSide> sides) {
    if (sides.size() != 1) return;
    ++count[sides[0].low];
    ++count[sides[0].high];
  });
  return count;
}

Mesh sound_remains(Mesh mesh) {
  remove_pinches(mesh);
  const std::vector<int> labels = vertex_components(mesh);
  const int largest = largest_component(mesh, labels);
  std::erase_if(mesh.faces, [&](const Face& face) { return labels[face[0]] != largest; });
  return mesh;
}

void drop_unused_vertices(SynthShape& shape) {
  const std::vector<int> numbers = compact_numbers(shape.mesh);
  shape.mesh.vertices = numbered(shape.mesh.vertices, numbers);
  shape.rest = numbered(shape.rest, numbers);
  for (Face& face : shape.mesh.faces) {
    for (int& v : face) v = numbers[v];
  }
  for (std::vector<int>* truth : {&shape.ground_truth, &shape.symmetric_ground_truth}) {
    for (int& v : *truth) {
      if (v != kUnmatched) v = numbers[v];
    }
  }
}

}  // namespace isomatch::synth
