// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "geometry/kd_tree.h"
#include "geometry/rotation.h"
#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

/// Surface face of each input face, `kNoFace` if none.
std::vector<int> surface_faces(const Surface& surface) {
  std::vector<int> faces(surface.num_input_faces, kNoFace);
  for (int f = 0; f < surface.mesh.num_faces(); ++f) faces[surface.input_face[f]] = f;
  return faces;
}

/// `point` on `face` after the face was turned, or turned back.
SurfacePoint turned(const SurfacePoint& point, int face, bool is_turned) {
  SurfacePoint result{face, point.weights};
  if (is_turned) std::swap(result.weights[1], result.weights[2]);
  return result;
}

int num_input_vertices(const Surface& surface) {
  return static_cast<int>(surface.surface_vertex.size());
}

void sort_without_repetition(Correspondence& matches) {
  std::ranges::sort(matches);
  const auto repeated = std::ranges::unique(matches);
  matches.erase(repeated.begin(), repeated.end());
}

}  // namespace

int surface_vertex(const Surface& surface, int input_vertex) {
  const std::size_t count = surface.surface_vertex.size();
  if (input_vertex < 0 || std::cmp_greater_equal(input_vertex, count))
    throw InvalidInput(fmt::format("vertex {} is out of range: there are {}", input_vertex, count));
  return surface.surface_vertex[input_vertex];
}

SurfaceMatches on_surfaces(const Surface& source, const Surface& target,
                           const Correspondence& matches) {
  Correspondence result;
  for (const Match& match : matches) {
    const int s = surface_vertex(source, match.source);
    const int t = surface_vertex(target, match.target);
    if (s != kNoVertex && t != kNoVertex) result.push_back({s, t});
  }
  sort_without_repetition(result);
  return SurfaceMatches(std::move(result));
}

SurfacePoints on_surfaces(const Surface& source, const Surface& target, const SurfaceMap& map) {
  check_map(map, num_input_vertices(source), target.num_input_faces);
  const std::vector<int> surface_face = surface_faces(target);
  SurfaceMap result(source.num_vertices());
  for (std::size_t v = 0; v < result.size(); ++v) {
    const SurfacePoint& point = map[source.input_vertex[v]];
    if (point.face == kNoFace) continue;
    const int face = surface_face[point.face];
    if (face != kNoFace) result[v] = turned(point, face, target.turned[face]);
  }
  return SurfacePoints(std::move(result));
}

OnSurface<VertexMap> on_surfaces(const Surface& source, const Surface& target,
                                 const VertexMap& map) {
  check_map(map, num_input_vertices(source), num_input_vertices(target));
  VertexMap result;
  for (int v : source.input_vertex)
    result.push_back(map[v] == kUnmatched ? kUnmatched : target.surface_vertex[map[v]]);
  return OnSurface(std::move(result));
}

SurfaceVertices on_surface(const Surface& surface, std::span<const int> vertices,
                           std::string_view name) {
  std::vector<int> result;
  for (const int vertex : vertices) {
    if (vertex < 0 || std::cmp_greater_equal(vertex, surface.surface_vertex.size()))
      throw InvalidInput(fmt::format("{} {} is out of range", name, vertex));
    result.push_back(surface.surface_vertex[vertex]);
    if (result.back() == kNoVertex)
      throw InvalidInput(fmt::format("{} {} is not on the surface that is matched", name, vertex));
  }
  return SurfaceVertices(std::move(result));
}

Correspondence to_input(const Surface& source, const Surface& target,
                        const SurfaceMatches& matches) {
  Correspondence result;
  for (const Match& match : *matches) {
    for (int s : source.input_vertices[match.source])
      for (int t : target.input_vertices[match.target]) result.push_back({s, t});
  }
  std::ranges::sort(result);
  return result;
}

SurfacePoint to_input(const Surface& target, const SurfacePoint& point) {
  return turned(point, target.input_face[point.face], target.turned[point.face]);
}

SurfaceMap to_input(const Surface& source, const Surface& target, const SurfacePoints& map) {
  SurfaceMap result(source.surface_vertex.size());
  for (std::size_t v = 0; v < result.size(); ++v) {
    const int vertex = source.surface_vertex[v];
    if (vertex == kNoVertex) continue;
    const SurfacePoint& point = (*map)[vertex];
    if (point.face != kNoFace) result[v] = to_input(target, point);
  }
  return result;
}

std::vector<int> to_input(const Surface& surface, const SurfaceVertices& vertices) {
  std::vector<int> result;
  for (const int vertex : *vertices)
    result.push_back(vertex == kUnmatched ? kUnmatched : surface.input_vertex[vertex]);
  return result;
}

namespace {

/// Where a place goes with the vertices of the surface around it: as they are turned, from the
/// nearest of them.
Point led(const Point& place, const Mesh& input, const Surface& surface, const KdTree<3>& tree,
          const std::vector<Point>& positions) {
  std::array<int, 16> leaders{};
  const std::size_t count = tree.nearest((place - surface.centre) / surface.scale, leaders);
  std::vector<Point> before, after;
  for (std::size_t k = 0; k < count; ++k) {
    before.push_back(input.vertices[surface.input_vertex[leaders[k]]]);
    after.push_back(positions[leaders[k]]);
  }
  if (before.empty()) return place;
  return after.front() + best_rotation(before, after) * (place - before.front());
}

}  // namespace

std::vector<Point> at_input(const Mesh& input, const Surface& surface,
                            const std::vector<Point>& positions) {
  std::optional<KdTree<3>> tree;  // As a rule all vertices are on the surface.
  std::vector<Point> result;
  for (int v = 0; v < input.num_vertices(); ++v) {
    const int own = surface.surface_vertex[v];
    if (own != kNoVertex) {
      result.push_back(positions[own]);
      continue;
    }
    const Point& place = input.vertices[v];
    if (!tree) tree.emplace(surface.mesh.vertices);
    result.push_back(led(place, input, surface, *tree, positions));
  }
  return result;
}

}  // namespace isomatch
