// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "carry/charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

namespace isomatch::transfer {
namespace {

/// Distances below this share of a face's size are rounding.
constexpr double kRounding = 1e-7;

double longest_edge(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  const auto& p = mesh.vertices;
  return std::max({(p[a] - p[b]).norm(), (p[b] - p[c]).norm(), (p[c] - p[a]).norm()});
}

}  // namespace

Charts::Charts(const Mesh& mesh, const Texture& texture)
    : texture_(texture),
      welded_(weld(mesh)),
      vertex_faces_(isomatch::vertex_faces(welded_.mesh)),
      neighbours_(face_neighbours(welded_.mesh)) {
  auto cut = neighbours_;
  for (int f = 0; f < mesh.num_faces(); ++f)
    for (int& neighbour : cut[f])
      if (neighbour != kNoFace && is_seam(f, neighbour)) neighbour = kNoFace;
  neighbours_ = std::move(cut);
}

Eigen::Vector2d Charts::corner_coordinates(int face, int vertex) const {
  const auto corner = std::ranges::find(mesh().faces[face], vertex) - mesh().faces[face].begin();
  return texture_.coordinates[texture_.corners[face][corner]];
}

bool Charts::is_seam(int face, int neighbour) const {
  if (texture_.covers(face) != texture_.covers(neighbour)) return true;
  if (!texture_.covers(face)) return false;
  if (texture_.face_material[face] != texture_.face_material[neighbour]) return true;
  return std::ranges::any_of(mesh().faces[face], [&](int v) {
    return std::ranges::count(mesh().faces[neighbour], v) > 0 &&
           corner_coordinates(face, v) != corner_coordinates(neighbour, v);
  });
}

std::vector<int> Charts::grow(std::span<const int> starts, const Ball& ball) const {
  std::vector<int> reached(starts.begin(), starts.end());
  std::unordered_set<int> known(starts.begin(), starts.end());
  for (std::size_t next = 0; next < reached.size(); ++next) {
    for (int face : neighbours_[reached[next]]) {
      if (face == kNoFace || known.contains(face)) continue;
      known.insert(face);
      const double squared = closest_point(mesh(), face, ball.centre).squared_distance;
      if (squared <= ball.radius * ball.radius) reached.push_back(face);
    }
  }
  return reached;
}

std::vector<int> Charts::faces_at(const SurfacePoint& point) const {
  const Point p = position(mesh(), point);
  const double tolerance = kRounding * longest_edge(mesh(), point.face);
  std::vector<int> faces{point.face};
  for (int v : mesh().faces[point.face]) {
    for (int face : vertex_faces_[v]) {
      if (std::ranges::count(faces, face) > 0) continue;
      if (closest_point(mesh(), face, p).squared_distance <= tolerance * tolerance)
        faces.push_back(face);
    }
  }
  return faces;
}

Eigen::Vector2d Charts::coordinates(const SurfacePoint& point) const {
  Eigen::Vector2d sum(0, 0);
  for (int k = 0; k < 3; ++k)
    sum += point.weights[k] * texture_.coordinates[texture_.corners[point.face][k]];
  return sum;
}

ClosestPoint nearest_point(const Mesh& mesh, std::span<const int> faces, const Point& p) {
  ClosestPoint best{{}, std::numeric_limits<double>::infinity()};
  for (int face : faces) {
    const ClosestPoint candidate = closest_point(mesh, face, p);
    if (std::sqrt(candidate.squared_distance) <
        std::sqrt(best.squared_distance) - kRounding * longest_edge(mesh, face))
      best = candidate;
  }
  return best;
}

}  // namespace isomatch::transfer
