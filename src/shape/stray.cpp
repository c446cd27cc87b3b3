// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/stray.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/kd_tree.h"
#include "isomatch/mesh/topology.h"
#include "isomatch/shape/diagnosis.h"

namespace isomatch {
namespace {

/// Where all but a hundredth of the vertices that faces use are.
struct Bulk {
  Point middle{0, 0, 0};
  double radius = 0;
};

double quantile(std::vector<double>& values, std::size_t place) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::ranges::nth_element(values, nth);
  return *nth;
}

Bulk bulk_of(const std::vector<Point>& points) {
  Bulk bulk;
  if (points.empty()) return bulk;
  std::vector<double> values(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::ranges::transform(points, values.begin(), [&](const Point& p) { return p[axis]; });
    bulk.middle[axis] = quantile(values, points.size() / 2);
  }
  std::ranges::transform(points, values.begin(),
                         [&](const Point& p) { return (p - bulk.middle).norm(); });
  bulk.radius = quantile(values, points.size() - 1 - points.size() / 100);
  return bulk;
}

/// The vertices that faces use and that are finite.
std::vector<int> used_vertices(const Mesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Face& face : mesh.faces)
    for (int v : face) used[v] = mesh.vertices[v].allFinite();
  std::vector<int> vertices;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (used[v]) vertices.push_back(v);
  return vertices;
}

/// Calls `visit(v, u)` for both directions of all edges.
template <class Visit>
void for_each_half_edge(const Mesh& mesh, const Visit& visit) {
  for (const Face& face : mesh.faces) {
    for (int corner = 0; corner < 3; ++corner) {
      visit(face[corner], face[(corner + 1) % 3]);
      visit(face[(corner + 1) % 3], face[corner]);
    }
  }
}

/// Makes vertices sound again that short edges join to sound ones: they are no spike but a coarsely
/// meshed part.
void keep_coarse_parts(const Mesh& mesh, double long_edge, std::vector<VertexKind>& kinds) {
  DisjointSets parts(mesh.num_vertices());
  for_each_half_edge(mesh, [&](int v, int u) {
    if (kinds[v] != VertexKind::kStray || kinds[u] == VertexKind::kNotFinite) return;
    if ((mesh.vertices[v] - mesh.vertices[u]).norm() < long_edge) parts.join(v, u);
  });
  std::vector<bool> has_sound(mesh.vertices.size(), false);
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (kinds[v] == VertexKind::kSound) has_sound[parts.find(v)] = true;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (kinds[v] == VertexKind::kStray && has_sound[parts.find(v)]) kinds[v] = VertexKind::kSound;
}

/// Vertices on open borders.
struct Border {
  std::vector<int> vertices;
  std::vector<Point> points;
  /// Pairs of vertices that an open edge joins, ascending.
  std::vector<std::pair<int, int>> edges;

  bool are_joined(int a, int b) const {
    return std::ranges::binary_search(edges, std::pair<int, int>(std::minmax(a, b)));
  }
};

Border border_of(const Mesh& mesh) {
  Border border;
  for_each_edge(sorted_edge_sides(mesh), [&](std::span<const EdgeSide> sides) {
    if (sides.size() != 1) return;
    border.edges.emplace_back(sides[0].low, sides[0].high);
    border.vertices.insert(border.vertices.end(), {sides[0].low, sides[0].high});
  });
  std::ranges::sort(border.edges);
  std::ranges::sort(border.vertices);
  const auto repeated = std::ranges::unique(border.vertices);
  border.vertices.erase(repeated.begin(), repeated.end());
  for (int v : border.vertices) border.points.push_back(mesh.vertices[v]);
  return border;
}

double mean_edge(const Mesh& mesh) {
  double sum = 0;
  for_each_half_edge(mesh,
                     [&](int v, int u) { sum += (mesh.vertices[v] - mesh.vertices[u]).norm(); });
  return sum / (6.0 * mesh.num_faces());
}

}  // namespace

std::vector<VertexKind> vertex_kinds(const Mesh& mesh) {
  constexpr double kFar = 4;
  // What reaches from the bulk to a vertex that far is at least this long.
  constexpr double kLong = kFar - 1;
  std::vector<VertexKind> kinds(mesh.vertices.size(), VertexKind::kSound);
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (!mesh.vertices[v].allFinite()) kinds[v] = VertexKind::kNotFinite;
  const std::vector<int> used = used_vertices(mesh);
  std::vector<Point> points;
  for (int v : used) points.push_back(mesh.vertices[v]);
  const Bulk bulk = bulk_of(points);
  if (bulk.radius == 0) return kinds;
  bool any = false;
  for (int v : used) {
    if ((mesh.vertices[v] - bulk.middle).norm() < kFar * bulk.radius) continue;
    kinds[v] = VertexKind::kStray;
    any = true;
  }
  if (any) keep_coarse_parts(mesh, kLong * bulk.radius, kinds);
  return kinds;
}

std::vector<int> stand_ins(const Mesh& mesh) {
  const std::vector<VertexKind> kinds = vertex_kinds(mesh);
  const auto sound = std::ranges::find(kinds, VertexKind::kSound);
  std::vector<int> result(mesh.vertices.size());
  std::iota(result.begin(), result.end(), 0);
  if (sound == kinds.end()) return result;
  for (std::size_t v = 0; v < result.size(); ++v)
    if (kinds[v] != VertexKind::kSound) result[v] = static_cast<int>(sound - kinds.begin());
  for_each_half_edge(mesh, [&](int v, int u) {
    if (kinds[v] != VertexKind::kSound && kinds[u] == VertexKind::kSound) result[v] = u;
  });
  return result;
}

int count_near_seam_vertices(const Mesh& mesh) {
  constexpr double kNear = 0.01;
  const Border border = border_of(mesh);
  if (border.points.empty()) return 0;
  const double bound = kNear * mean_edge(mesh);
  const KdTree<3> tree(border.points);
  int count = 0;
  for (std::size_t i = 0; i < border.points.size(); ++i) {
    // Itself, its neighbours along the border, and one more.
    std::array<int, 4> nearest{};
    const std::size_t found = tree.nearest(border.points[i], nearest);
    count += std::ranges::any_of(std::span(nearest).first(found), [&](int other) {
      const double distance = (border.points[other] - border.points[i]).norm();
      return distance > 0 && distance < bound &&
             !border.are_joined(border.vertices[i], border.vertices[other]);
    });
  }
  return count;
}

}  // namespace isomatch
