// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/shape/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "isomatch/mesh/topology.h"
#include "shape/inspection.h"
#include "shape/sound_mesh.h"
#include "shape/stray.h"

namespace isomatch {
namespace {

int count_unreferenced(const Mesh& mesh) {
  std::vector<char> unreferenced(mesh.vertices.size(), 1);
  for (const Face& face : mesh.faces) {
    for (int v : face) unreferenced[v] = 0;
  }
  return static_cast<int>(std::ranges::count(unreferenced, 1));
}

double finite_area(const Mesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.num_faces(); ++f) {
    const double area = face_area(mesh, f);
    if (std::isfinite(area)) sum += area;
  }
  return sum;
}

/// Coinciding vertices of a `SoundMesh` are adjacent.
int count_duplicate_vertices(const SoundMesh& sound) {
  const std::vector<Point>& points = sound.mesh.vertices;
  int duplicates = 0;
  for (std::size_t v = 1; v < points.size(); ++v) duplicates += points[v] == points[v - 1];
  // Those that are not finite lie in one place there.
  return duplicates - std::max(0, sound.not_finite_vertices - 1);
}

void measure_edges(const Mesh& mesh, MeshDiagnosis& diagnosis) {
  double sum = 0, shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for_each_edge(sorted_edge_sides(mesh), [&](std::span<const EdgeSide> edge) {
    const double length = (mesh.vertices[edge[0].low] - mesh.vertices[edge[0].high]).norm();
    sum += length;
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  });
  diagnosis.min_edge = shortest;
  diagnosis.mean_edge = sum / diagnosis.surface.edges;
  diagnosis.max_edge = longest;
}

/// Edges that are long for the mesh and for the shape.
int count_long_edges(const Mesh& mesh, double mean, double area) {
  constexpr double kMeans = 20, kShare = 0.5;
  const double bound = std::max(kMeans * mean, kShare * std::sqrt(area));
  int count = 0;
  for_each_edge(sorted_edge_sides(mesh), [&](std::span<const EdgeSide> edge) {
    count += (mesh.vertices[edge[0].low] - mesh.vertices[edge[0].high]).norm() > bound;
  });
  return count;
}

void inspect_surface(const ExtractedSurface& surface, MeshDiagnosis& diagnosis) {
  const bool is_given =
      surface.joined_edges == 0 && surface.mesh.num_faces() == diagnosis.given.faces;
  diagnosis.surface = is_given ? diagnosis.given : connectivity(surface.mesh);
  diagnosis.components = surface.components;
  diagnosis.joined_edges = surface.joined_edges;
  diagnosis.matchable_vertices =
      diagnosis.vertices - static_cast<int>(std::ranges::count(surface.surface_vertex, kNoVertex));
  diagnosis.matchable_area_share = surface.area / surface.total_area;
  measure_edges(surface.mesh, diagnosis);
  diagnosis.long_edges = count_long_edges(surface.mesh, diagnosis.mean_edge, surface.area);
}

std::string component_warning(int components, double share) {
  const std::string others =
      components == 2 ? "the other follows" : fmt::format("the other {} follow", components - 1);
  const long percent = std::min(99L, std::lround(100 * share));  // never all of several
  return fmt::format("{} components: the largest ({} % of the area) is matched, {}", components,
                     percent, others);
}

/// Less of the area than this says little about the whole.
constexpr double kSmallShare = 0.5;

/// Something countable that is wrong, said of one and of many.
struct Defect {
  int number;
  const char* one;
  const char* many;
};

/// A seam across the shape has about as many vertices as a side of a square of all of them.
bool is_torn(const MeshDiagnosis& d) { return d.near_seam_vertices > std::sqrt(d.vertices) / 2; }

/// Those for which a map is not to be trusted without a look.
std::array<Defect, 3> grave_defects(const MeshDiagnosis& d) {
  return {
      {{d.stray_vertices, "1 stray vertex far outside of the shape: left out, unmatched",
        "{} stray vertices far outside of the shape: left out, unmatched"},
       {d.long_edges, "1 edge far longer than those around it: a spike or a bridge?",
        "{} edges far longer than those around them: spikes or bridges?"},
       {is_torn(d) ? d.near_seam_vertices : 0,
        "1 vertex of an open border nearly coincides with another one: the surface is torn there; "
        "merge vertices by distance first",
        "{} vertices of open borders nearly coincide with others: the surface is torn there; merge "
        "vertices by distance first"}}};
}

std::array<Defect, 8> countable_defects(const MeshDiagnosis& d) {
  return {
      {{d.not_finite_vertices, "1 vertex with a coordinate that is not a number: unmatched",
        "{} vertices with coordinates that are not numbers: unmatched"},
       {d.degenerate_faces, "1 face without area: ignored", "{} faces without area: ignored"},
       {d.duplicate_faces, "1 face that repeats another: ignored",
        "{} faces that repeat others: ignored"},
       {d.unreferenced_vertices,
        "1 vertex without a face: matched only where it coincides with another",
        "{} vertices without a face: matched only where they coincide with others"},
       {d.joined_edges, "1 open seam edge whose two sides coincide: joined",
        "{} open seam edges whose two sides coincide: joined"},
       {d.surface.nonmanifold_edges, "1 edge of more than two faces: the surface branches there",
        "{} edges of more than two faces: the surface branches there"},
       {d.surface.nonmanifold_vertices,
        "1 vertex in which parts of the surface only touch: distances pass through it",
        "{} vertices in which parts of the surface only touch: distances pass through them"},
       {d.surface.orientable ? d.surface.inconsistent_edges : 0,
        "1 edge between faces that face opposite ways: inside and outside are mixed up",
        "{} edges between faces that face opposite ways: inside and outside are mixed up"}}};
}

template <class Defects>
void append(const Defects& defects, std::vector<std::string>& list) {
  for (const auto& [number, one, many] : defects) {
    if (number > 0) list.push_back(fmt::format(fmt::runtime(number == 1 ? one : many), number));
  }
}

std::string border_warning(const Connectivity& surface) {
  const std::string borders = surface.boundary_loops == 1
                                  ? "1 hole or open border"
                                  : fmt::format("{} holes or open borders", surface.boundary_loops);
  return fmt::format(
      "{} ({} edges): distances lead around; with a long border a shape is taken for a part",
      borders, surface.boundary_edges);
}

}  // namespace

Inspection inspect(const Mesh& mesh) {
  validate(mesh);
  SoundMesh sound = sound_mesh(mesh);
  Inspection inspection;
  MeshDiagnosis& diagnosis = inspection.diagnosis;
  diagnosis.vertices = mesh.num_vertices();
  diagnosis.faces = mesh.num_faces();
  diagnosis.area = finite_area(mesh);
  diagnosis.not_finite_vertices = sound.not_finite_vertices;
  diagnosis.stray_vertices = sound.stray_vertices;
  diagnosis.degenerate_faces = sound.degenerate_faces;
  diagnosis.duplicate_faces = sound.duplicate_faces;
  diagnosis.unreferenced_vertices = count_unreferenced(mesh);
  diagnosis.duplicate_vertices = count_duplicate_vertices(sound);
  diagnosis.given = connectivity(sound.mesh);
  if (sound.mesh.faces.empty()) return inspection;
  diagnosis.near_seam_vertices = count_near_seam_vertices(sound.mesh);
  inspection.surface = largest_surface(std::move(sound));
  inspect_surface(*inspection.surface, diagnosis);
  return inspection;
}

MeshDiagnosis diagnose(const Mesh& mesh) { return inspect(mesh).diagnosis; }

std::vector<std::string> MeshDiagnosis::grave_warnings() const {
  std::vector<std::string> list;
  if (surface.faces > 0 && matchable_area_share < kSmallShare)
    list.push_back(component_warning(components, matchable_area_share));
  append(grave_defects(*this), list);
  return list;
}

std::vector<std::string> MeshDiagnosis::warnings() const {
  if (surface.faces == 0) return {"no face has an area: there is nothing to match"};
  std::vector<std::string> list = grave_warnings();
  if (components > 1 && matchable_area_share >= kSmallShare)
    list.push_back(component_warning(components, matchable_area_share));
  append(countable_defects(*this), list);
  if (surface.boundary_loops > 0) list.push_back(border_warning(surface));
  if (!surface.orientable)
    list.push_back("the surface has one side only, like a Moebius strip: no inside and outside");
  return list;
}

}  // namespace isomatch
