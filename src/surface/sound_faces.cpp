// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "surface/sound_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "isomatch/topology.h"
#include "surface/sorted_faces.h"

namespace isomatch {
namespace {

/// Area zero, or so small that it is only the coordinates' rounding error.
bool has_zero_area(const Mesh& mesh, const Face& face) {
  const Point &a = mesh.vertices[face[0]], &b = mesh.vertices[face[1]], &c = mesh.vertices[face[2]];
  const double coordinate = a.cwiseAbs().cwiseMax(b.cwiseAbs()).cwiseMax(c.cwiseAbs()).maxCoeff();
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  return (b - a).cross(c - a).norm() <= kRounding * coordinate * longest;
}

bool is_degenerate(const Mesh& mesh, const Face& face) {
  return has_repeated_vertex(face) || has_zero_area(mesh, face);
}

/// Keeps the lowest face of those that have the same vertices. Returns the number dropped.
int drop_duplicates(SoundFaces& sound) {
  const std::vector<SortedFace> sorted = sorted_faces(sound.mesh);
  std::vector<char> keep(sorted.size(), 1);
  for (std::size_t i = 1; i < sorted.size(); ++i)
    keep[sorted[i].face] = sorted[i].vertices != sorted[i - 1].vertices;
  std::size_t kept = 0;
  for (std::size_t f = 0; f < keep.size(); ++f) {
    if (!keep[f]) continue;
    sound.mesh.faces[kept] = sound.mesh.faces[f];
    sound.input_face[kept++] = sound.input_face[f];
  }
  sound.mesh.faces.resize(kept);
  sound.input_face.resize(kept);
  return static_cast<int>(keep.size() - kept);
}

}  // namespace

SoundFaces sound_faces(const Mesh& input) {
  SoundFaces sound{{input.vertices, {}}, {}};
  for (int f = 0; f < input.num_faces(); ++f) {
    if (is_degenerate(input, input.faces[f])) continue;
    sound.mesh.faces.push_back(input.faces[f]);
    sound.input_face.push_back(f);
  }
  sound.degenerate_faces = input.num_faces() - sound.mesh.num_faces();
  sound.duplicate_faces = drop_duplicates(sound);
  return sound;
}

}  // namespace isomatch
