// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/sound_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <span>
#include <utility>

#include "geometry/bucket_sort.h"
#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "shape/hilbert.h"
#include "shape/stray.h"

namespace isomatch {
namespace {

/// A face by its vertices in ascending order.
struct SortedFace {
  Face vertices;
  int face;

  auto operator<=>(const SortedFace&) const = default;
};

std::vector<SortedFace> sorted_faces(int num_vertices, std::span<const Face> faces) {
  return bucket_sorted<SortedFace>(num_vertices, [&](const auto& sink) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      Face vertices = faces[f];
      std::ranges::sort(vertices);
      sink(vertices[0], SortedFace{vertices, static_cast<int>(f)});
    }
  });
}

/// The area of a face, 0 where it is degenerate: a vertex repeats, or the area is so small that it
/// is only the rounding error of the coordinates.
double sound_area(const Mesh& mesh, const Face& face) {
  if (has_repeated_vertex(face)) return 0;
  const Point &a = mesh.vertices[face[0]], &b = mesh.vertices[face[1]], &c = mesh.vertices[face[2]];
  const double coordinate = a.cwiseAbs().cwiseMax(b.cwiseAbs()).cwiseMax(c.cwiseAbs()).maxCoeff();
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const double doubled = (b - a).cross(c - a).norm();
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  return doubled > kRounding * coordinate * longest ? doubled / 2 : 0;
}

void check_range(const Mesh& mesh) {
  constexpr double kLargest = 1e100;  // Areas and their sums are finite.
  for (const Face& face : mesh.faces) {
    for (int v : face) {
      const Point& p = mesh.vertices[v];
      if (p.allFinite() && p.cwiseAbs().maxCoeff() > kLargest)
        throw InvalidInput(fmt::format(
            "vertex {} has a coordinate beyond {:g}, of which areas are not finite", v, kLargest));
    }
  }
}

/// The vertices of `input`, those that are not finite at a place where no other is.
std::vector<Point> finite_vertices(const Mesh& input, std::span<const VertexKind> kinds) {
  std::vector<Point> points = input.vertices;
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (kinds[v] != VertexKind::kNotFinite) box.extend(points[v]);
  const Point outside = box.isEmpty() ? Point(0, 0, 0) : Point(box.max() + box.sizes());
  for (std::size_t v = 0; v < points.size(); ++v)
    if (kinds[v] == VertexKind::kNotFinite) points[v] = outside;
  return points;
}

/// The vertices of `input` along a Hilbert curve, and its faces, in input order, in their numbers.
SoundMesh renumbered(const Mesh& input, std::span<const VertexKind> kinds) {
  SoundMesh sound;
  const std::vector<Point> points = finite_vertices(input, kinds);
  sound.input_vertex = hilbert_order(points);
  sound.not_finite_vertices = static_cast<int>(std::ranges::count(kinds, VertexKind::kNotFinite));
  sound.stray_vertices = static_cast<int>(std::ranges::count(kinds, VertexKind::kStray));
  std::vector<int> number(input.vertices.size());
  sound.mesh.vertices.reserve(input.vertices.size());
  for (int v : sound.input_vertex) {
    number[v] = sound.mesh.num_vertices();
    sound.mesh.vertices.push_back(points[v]);
  }
  sound.num_input_faces = input.num_faces();
  sound.mesh.faces.reserve(input.faces.size());
  for (const auto& [a, b, c] : input.faces)
    sound.mesh.faces.push_back({number[a], number[b], number[c]});
  return sound;
}

}  // namespace

SoundMesh sound_mesh(const Mesh& input) {
  check_range(input);
  const std::vector<VertexKind> kinds = vertex_kinds(input);
  SoundMesh sound = renumbered(input, kinds);
  const std::vector<Face> faces = std::exchange(sound.mesh.faces, {});
  sound.mesh.faces.reserve(faces.size());
  sound.input_face.reserve(faces.size());
  sound.face_areas.reserve(faces.size());
  Face previous{-1, -1, -1};
  for (const auto& [vertices, face] : sorted_faces(input.num_vertices(), faces)) {
    const bool is_left_out = std::ranges::any_of(
        input.faces[face], [&](int v) { return kinds[v] != VertexKind::kSound; });
    if (is_left_out) continue;
    const double area = sound_area(sound.mesh, vertices);
    const bool is_duplicate = std::exchange(previous, vertices) == vertices;
    if (area == 0) {
      ++sound.degenerate_faces;
    } else if (is_duplicate) {
      ++sound.duplicate_faces;
    } else {
      sound.mesh.faces.push_back(faces[face]);
      sound.input_face.push_back(face);
      sound.face_areas.push_back(area);
    }
  }
  return sound;
}

}  // namespace isomatch
