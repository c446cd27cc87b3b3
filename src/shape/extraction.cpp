// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/extraction.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "geometry/runs.h"
#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "shape/seams.h"
#include "shape/sound_mesh.h"

namespace isomatch {
namespace {

void apply(const Seams& seams, Mesh& mesh) {
  for (Face& face : mesh.faces) {
    for (int& v : face) v = seams.joined_vertex[v];
  }
}

/// The faces of the component of largest area, ascending; fills in the figures about components.
std::vector<int> largest_component(const SoundMesh& sound, ExtractedSurface& surface) {
  const std::vector<int> label = vertex_components(sound.mesh);
  std::vector<double> areas(sound.mesh.vertices.size(), 0.0);
  const auto component = [&](int face) { return label[sound.mesh.faces[face][0]]; };
  for (int f = 0; f < sound.mesh.num_faces(); ++f) areas[component(f)] += sound.face_areas[f];
  const auto largest = std::ranges::max_element(areas);
  surface.components =
      static_cast<int>(std::ranges::count_if(areas, [](double a) { return a > 0; }));
  surface.area = *largest;
  surface.total_area = std::accumulate(areas.begin(), areas.end(), 0.0);

  std::vector<int> faces;
  for (int f = 0; f < sound.mesh.num_faces(); ++f) {
    if (component(f) == largest - areas.begin()) faces.push_back(f);
  }
  return faces;
}

/// Moves `faces` and their vertices into `surface`, closing the gaps. Returns the surface vertex of
/// each vertex of `sound`.
std::vector<int> take(const SoundMesh& sound, std::span<const int> faces,
                      ExtractedSurface& surface) {
  std::vector<int> number(sound.mesh.vertices.size(), kNoVertex);
  for (int f : faces) {
    for (int v : sound.mesh.faces[f]) number[v] = 0;
  }
  for (int v = 0; v < sound.mesh.num_vertices(); ++v) {
    if (number[v] == kNoVertex) continue;
    number[v] = surface.mesh.num_vertices();
    surface.mesh.vertices.push_back(sound.mesh.vertices[v]);
    surface.input_vertex.push_back(sound.input_vertex[v]);
  }
  for (int f : faces) {
    const auto& [a, b, c] = sound.mesh.faces[f];
    surface.mesh.faces.push_back({number[a], number[b], number[c]});
    surface.input_face.push_back(sound.input_face[f]);
  }
  return number;
}

std::vector<char> vertices_with_faces(const Mesh& mesh) {
  std::vector<char> has_face(mesh.vertices.size(), 0);
  for (const Face& face : mesh.faces) {
    for (int v : face) has_face[v] = 1;
  }
  return has_face;
}

/// Gives vertices without a face, such as the spare copies that modelling programs leave at the
/// poles of a sphere, the number of the first coinciding vertex that has one.
void adopt_loose_vertices(const Mesh& mesh, std::span<const char> has_face,
                          std::vector<int>& number) {
  const auto coincide = [&](int a, int b) { return mesh.vertices[a] == mesh.vertices[b]; };
  for_each_run(mesh.num_vertices(), coincide, [&](int first, int last) {
    const auto run = std::span(number).subspan(first, last - first);
    const auto taken = std::ranges::find_if(run, [](int n) { return n != kNoVertex; });
    if (taken == run.end()) return;
    for (int v = first; v < last; ++v) {
      if (!has_face[v]) number[v] = *taken;
    }
  });
}

}  // namespace

ExtractedSurface largest_surface(SoundMesh sound) {
  const std::vector<char> has_face = vertices_with_faces(sound.mesh);
  const Seams seams = join_seams(sound.mesh);
  apply(seams, sound.mesh);

  ExtractedSurface surface;
  surface.degenerate_faces = sound.degenerate_faces;
  surface.duplicate_faces = sound.duplicate_faces;
  surface.joined_edges = seams.joined_edges;
  surface.num_input_faces = sound.num_input_faces;
  std::vector<int> number = take(sound, largest_component(sound, surface), surface);
  for (std::size_t v = 0; v < number.size(); ++v) number[v] = number[seams.joined_vertex[v]];
  adopt_loose_vertices(sound.mesh, has_face, number);
  surface.surface_vertex.resize(number.size());
  for (std::size_t v = 0; v < number.size(); ++v)
    surface.surface_vertex[sound.input_vertex[v]] = number[v];
  for (int v = static_cast<int>(number.size()) - 1; v >= 0; --v)
    if (surface.surface_vertex[v] != kNoVertex) surface.input_vertex[surface.surface_vertex[v]] = v;
  return surface;
}

ExtractedSurface extract_surface(const Mesh& input) {
  validate(input);
  SoundMesh sound = sound_mesh(input);
  if (sound.mesh.faces.empty()) throw InvalidInput("the mesh has no face of positive area");
  return largest_surface(std::move(sound));
}

}  // namespace isomatch
