// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// What any consumer does: includes public headers, links, and gets a right answer.
#include <isomatch/error.h>
#include <isomatch/mesh/synth.h>
#include <isomatch/methods/tracked.h>
#include <isomatch/version.h>

#include <iostream>
#include <string_view>

namespace {

/// How many vertices of a shape matched to itself stay where they are.
int fixed_vertices(const isomatch::Mesh& mesh) {
  const isomatch::Shape shape(mesh);
  const isomatch::TrackedResult result = isomatch::match_tracked(shape, shape);
  const isomatch::VertexMap map =
      isomatch::nearest_vertices(mesh, result.maps.front().source_to_target);
  int fixed = 0;
  for (int v = 0; v < mesh.num_vertices(); ++v) fixed += map[v] == v ? 1 : 0;
  return fixed;
}

bool throws_its_exceptions() {
  try {
    const isomatch::Shape shape{isomatch::Mesh{}};
  } catch (const isomatch::InvalidInput&) {
    return true;
  }
  return false;
}

}  // namespace

int main() {
  if (isomatch::kVersion != std::string_view(EXPECTED_VERSION) || !throws_its_exceptions())
    return 1;
  const isomatch::Mesh mesh = isomatch::synthesize({.vertices = 1000, .pose = 1}).mesh;
  const int fixed = fixed_vertices(mesh);
  std::cout << fixed << " of " << mesh.num_vertices() << " vertices stay\n";
  return fixed >= 0.99 * mesh.num_vertices() ? 0 : 1;
}
