// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/skin.h"

#include <cmath>

#include "synth/contour.h"
#include "synth/remesher.h"

namespace isomatch::synth {
namespace {

/// Larger meshes are made by dividing the faces of one of at most this size.
constexpr int kMaxBase = 40000;

/// A lattice spacing that makes about `vertices` vertices, and fine enough for the thinnest parts.
double lattice_spacing(int vertices) {
  constexpr double kAreaEstimate = 3, kThinnest = 0.035;
  return std::min(kThinnest, std::sqrt(4.5 * kAreaEstimate / vertices));
}

void even_out(Remesher& remesher, int vertices) {
  remesher.collapse_to(vertices);
  for (int round = 0; round < 3; ++round) {
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
  int base = vertices, divisions = 0;
  for (; base > kMaxBase; ++divisions) base = (base - 2 + 3) / 4 + 2;
  const Mesh mesh = contour(body, lattice_spacing(base * 3 / 2), random, context);
  Remesher remesher(body, pose, mesh, context);
  even_out(remesher, base);
  for (int i = 0; i < divisions; ++i) {
    remesher.subdivide();
    remesher.flip();
    remesher.relax();
  }
  remesher.flip();
  return remesher.take();
}

}  // namespace isomatch::synth
