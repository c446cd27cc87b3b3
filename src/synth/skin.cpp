// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/skin.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "synth/contour.h"
#include "synth/remesher.h"

namespace isomatch::synth {
namespace {

/// Larger meshes are made by dividing the faces of one of at most this size.
constexpr int kMaxBase = 40000;

constexpr std::string_view kStage = "meshing";

bool is_sphere(const Mesh& mesh) {
  const std::vector<int> components = vertex_components(mesh);
  return *std::max_element(components.begin(), components.end()) == 0 &&
         mesh.num_faces() == 2 * mesh.num_vertices() - 4;
}

/// A first triangulation with more than `vertices` vertices, whatever their shape.
Mesh triangulate(const Body& body, int vertices, Random& random, const Context& context) {
  // Areas are between 2.5 and 4; thin parts, such as ears, need a minimum of resolution.
  double spacing = std::min(0.04, std::sqrt(4.5 * 2.5 / vertices));
  for (int attempt = 0; attempt < 5; ++attempt, spacing *= 0.7) {
    Mesh mesh = contour(body, spacing, random, context);
    if (is_sphere(mesh) && mesh.num_vertices() >= vertices) return mesh;
  }
  throw InternalError("the skin of a synthetic body is not a sphere");
}

void even_out(Remesher& remesher, int vertices, const Context& context) {
  remesher.collapse_to(vertices);
  for (int round = 0; round < 3; ++round) {
    context.check_stop();
    const double edge = std::sqrt(2 * remesher.area() / (std::sqrt(3.0) * vertices));
    remesher.split_above(4.0 / 3 * edge);
    remesher.collapse_to(vertices);
    for (int i = 0; i < 2; ++i) {
      remesher.flip();
      remesher.relax();
    }
  }
  remesher.flip();
}

}  // namespace

Skin mesh_skin(const Body& body, const Pose& pose, int vertices, Random& random,
               const Context& context) {
  context.report(0, kStage);
  int base = vertices, divisions = 0;
  for (; base > kMaxBase; ++divisions) base = (base - 2 + 3) / 4 + 2;
  const Mesh mesh = triangulate(body, base * 5 / 4, random, context);
  Remesher remesher(body, pose, mesh, context);
  even_out(remesher, base, context);
  for (int i = 0; i < divisions; ++i) {
    context.report(static_cast<double>(remesher.num_vertices()) / vertices, kStage);
    remesher.subdivide();
    remesher.flip();
    remesher.relax();
  }
  remesher.flip();
  return remesher.take();
}

}  // namespace isomatch::synth
