// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/measure/registered_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/face_orientation.h"
#include "geometry/face_tree.h"
#include "geometry/hat_gradients.h"
#include "isomatch/error.h"
#include "parallel.h"

namespace isomatch {
namespace {

/// Zero where coordinates are not finite.
std::vector<double> face_areas(const Mesh& mesh) {
  std::vector<double> areas(mesh.faces.size());
  for (int f = 0; f < mesh.num_faces(); ++f) {
    const double area = face_area(mesh, f);
    areas[f] = std::isfinite(area) ? area : 0;
  }
  return areas;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

double folded_share(const Mesh& source, const Mesh& registered, const std::vector<double>& areas) {
  std::vector<bool> folded(areas.size(), false);
  for (const auto& [f, g, sign] : hinges(source)) {
    const Point normal = area_vector(registered.vertices, source.faces[f]);
    if (sign * normal.dot(area_vector(registered.vertices, source.faces[g])) < 0)
      folded[f] = folded[g] = true;
  }
  double count = 0, of = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    if (areas[f] == 0) continue;
    ++of;
    if (folded[f]) ++count;
  }
  return of > 0 ? count / of : 0;
}

double squeezed_share(const std::vector<double>& source, const std::vector<double>& registered) {
  constexpr double kSqueezed = 0.1;
  const double limit = kSqueezed * sum(registered) / sum(source);
  double count = 0, of = 0;
  for (std::size_t f = 0; f < source.size(); ++f) {
    if (source[f] == 0) continue;
    ++of;
    if (registered[f] <= limit * source[f]) ++count;
  }
  return of > 0 ? count / of : 0;
}

/// The share of a face that is within `distance` of a surface, judged by the middles of congruent
/// pieces that are no longer than that; of a needle, which would have many more, of fewer.
double reached_share(const Mesh& mesh, int face, const FaceTree& surface, double distance) {
  const auto& [a, b, c] = mesh.faces[face];
  const Point& origin = mesh.vertices[a];
  const Point u = mesh.vertices[b] - origin, v = mesh.vertices[c] - origin;
  const double longest = std::max({u.norm(), v.norm(), (v - u).norm()});
  constexpr double kMost = 500;
  const int n = static_cast<int>(std::clamp(std::ceil(longest / distance), 1.0, kMost));
  int reached = 0;
  const auto look = [&](int i, int j, double middle) {
    const Point p = origin + (i + middle) / n * u + (j + middle) / n * v;
    if (surface.is_within(p, distance)) ++reached;
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      look(i, j, 1.0 / 3);
      if (i + j + 1 < n) look(i, j, 2.0 / 3);
    }
  }
  return static_cast<double>(reached) / (static_cast<double>(n) * n);
}

double reach(const Mesh& registered, const Mesh& target, const Context& context) {
  constexpr double kReachedWithin = 0.01;
  std::vector<double> areas = face_areas(target);
  const double area = sum(areas), distance = kReachedWithin * std::sqrt(area);
  const FaceTree tree(registered);
  parallel_for(std::ssize(areas), context, [&](std::ptrdiff_t f) {
    if (areas[f] > 0) areas[f] *= reached_share(target, static_cast<int>(f), tree, distance);
  });
  return area > 0 ? sum(areas) / area : 0;
}

}  // namespace

RegisteredSurface measure_registered(const Mesh& source, std::span<const Point> registered,
                                     const Mesh& target, const Context& context) {
  validate(source);
  validate(target);
  if (registered.size() != source.vertices.size())
    throw InvalidInput(fmt::format("{} registered positions, but {} vertices of the source",
                                   registered.size(), source.vertices.size()));
  const Mesh mesh{{registered.begin(), registered.end()}, source.faces};
  const std::vector<double> areas = face_areas(source);
  return {folded_share(source, mesh, areas), squeezed_share(areas, face_areas(mesh)),
          reach(mesh, target, context)};
}

}  // namespace isomatch
