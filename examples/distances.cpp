// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// A stage alone: vertices spread evenly over a mesh, and how far along the surface each is from the
// first.
#include <exception>
#include <iostream>
#include <numeric>
#include <vector>

#include "isomatch/geodesics/geodesics.h"
#include "isomatch/io/mesh_io.h"

namespace {

void print_distances(const char* file) {
  const isomatch::Mesh mesh = isomatch::read_mesh(file);
  const isomatch::GeodesicGraph graph(mesh, isomatch::GeodesicOptions::w10());

  std::vector<int> vertices(mesh.num_vertices());
  std::iota(vertices.begin(), vertices.end(), 0);
  const std::vector<int> spread = isomatch::farthest_points(graph, vertices, 10);
  const std::vector<float> field = isomatch::geodesic_fields(graph, std::vector{spread.front()});
  for (const int vertex : spread) std::cout << vertex << ' ' << field[vertex] << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: example_distances MESH\n";
    return 2;
  }
  try {
    print_distances(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
