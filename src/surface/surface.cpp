// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/surface.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "isomatch/error.h"
#include "isomatch/topology.h"
#include "surface/hilbert.h"
#include "surface/seams.h"
#include "surface/sorted_faces.h"
#include "surface/sound_faces.h"

namespace isomatch {
namespace {

void apply(const Seams& seams, Mesh& mesh) {
  for (Face& face : mesh.faces) {
    for (int& v : face) v = seams.joined_vertex[v];
  }
}

/// The faces of the component of largest area, ascending; fills in the figures about components.
std::vector<int> largest_component(const Mesh& mesh, Surface& surface) {
  const std::vector<int> label = vertex_components(mesh);
  std::vector<double> areas(mesh.vertices.size(), 0.0);
  for (int f = 0; f < mesh.num_faces(); ++f) areas[label[mesh.faces[f][0]]] += face_area(mesh, f);
  const auto largest = std::ranges::max_element(areas);
  surface.components =
      static_cast<int>(std::ranges::count_if(areas, [](double a) { return a > 0; }));
  surface.area = *largest;
  surface.total_area = std::accumulate(areas.begin(), areas.end(), 0.0);

  std::vector<int> faces;
  for (int f = 0; f < mesh.num_faces(); ++f) {
    if (label[mesh.faces[f][0]] == largest - areas.begin()) faces.push_back(f);
  }
  return faces;
}

/// Numbers the vertices of `faces` along a Hilbert curve.
void take_vertices(const Mesh& mesh, std::span<const int> faces, Surface& surface) {
  surface.surface_vertex.assign(mesh.vertices.size(), kNoVertex);
  for (int f : faces) {
    for (int v : mesh.faces[f]) surface.surface_vertex[v] = 0;
  }
  std::vector<int> used;
  std::vector<Point> points;
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    if (surface.surface_vertex[v] == kNoVertex) continue;
    used.push_back(v);
    points.push_back(mesh.vertices[v]);
  }
  for (int i : hilbert_order(points)) {
    surface.surface_vertex[used[i]] = surface.mesh.num_vertices();
    surface.mesh.vertices.push_back(points[i]);
    surface.input_vertex.push_back(used[i]);
  }
}

/// Takes `faces` over in the new vertex numbers, those near each other in memory that share
/// vertices.
void take_faces(const SoundFaces& sound, std::span<const int> faces, Surface& surface) {
  Mesh renumbered{surface.mesh.vertices, {}};
  renumbered.faces.reserve(faces.size());
  for (int f : faces) {
    const auto& [a, b, c] = sound.mesh.faces[f];
    const auto& number = surface.surface_vertex;
    renumbered.faces.push_back({number[a], number[b], number[c]});
  }
  for (const SortedFace& sorted : sorted_faces(renumbered)) {
    surface.mesh.faces.push_back(renumbered.faces[sorted.face]);
    surface.input_face.push_back(sound.input_face[faces[sorted.face]]);
  }
}

}  // namespace

Surface extract_surface(const Mesh& input) {
  validate(input);
  SoundFaces sound = sound_faces(input);
  if (sound.input_face.empty()) throw InvalidInput("the mesh has no face of positive area");
  const Seams seams = join_seams(sound.mesh);
  apply(seams, sound.mesh);

  Surface surface;
  surface.degenerate_faces = sound.degenerate_faces;
  surface.duplicate_faces = sound.duplicate_faces;
  surface.joined_edges = seams.joined_edges;
  const std::vector<int> faces = largest_component(sound.mesh, surface);
  take_vertices(sound.mesh, faces, surface);
  take_faces(sound, faces, surface);
  for (int v = 0; v < input.num_vertices(); ++v)
    surface.surface_vertex[v] = surface.surface_vertex[seams.joined_vertex[v]];
  return surface;
}

}  // namespace isomatch
