// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "carry/seam_cutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace isomatch::transfer {
namespace {

/// Where an edge is cut: between its lower (0) and its higher end (1), and on the source.
struct Cut {
  double share;
  SurfacePoint point;
};

/// Ends closer than this to a cut, as a share of the edge, are taken to lie on the seam.
constexpr double kLeastShare = 1e-3;

/// A point near `p` where two sides meet, by projecting onto one and the other in turn: `p` lies
/// off the surface, so that its foot on one of them need not be on the seam.
SurfacePoint between(const Mesh& mesh, const std::vector<int>& a, const std::vector<int>& b,
                     const Point& p) {
  constexpr int kRounds = 4;
  SurfacePoint result = nearest_point(mesh, a, p).point;
  for (int i = 0; i < kRounds; ++i) {
    const SurfacePoint across = nearest_point(mesh, b, position(mesh, result)).point;
    result = nearest_point(mesh, a, position(mesh, across)).point;
  }
  return result;
}

/// Where a seam crosses the way from `a` to `b`, if one does.
std::optional<Cut> find_cut(const Charts& charts, const SurfacePoint& a, const SurfacePoint& b) {
  constexpr double kBulge = 1.5;
  constexpr int kBisections = 30;
  const Point from = position(charts.mesh(), a), to = position(charts.mesh(), b);
  const Ball ball{(from + to) / 2, kBulge * (to - from).norm() / 2};
  const std::vector<int> near_a = charts.grow(charts.faces_at(a), ball);
  const auto distance = [&](const std::vector<int>& faces, const Point& p) {
    return std::sqrt(nearest_point(charts.mesh(), faces, p).squared_distance);
  };
  if (distance(near_a, to) <= kLeastShare * (to - from).norm()) return std::nullopt;
  const std::vector<int> near_b = charts.grow(charts.faces_at(b), ball);
  if (distance(near_b, from) <= kLeastShare * (to - from).norm()) return std::nullopt;
  double low = 0, high = 1;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (low + high) / 2;
    const Point p = from + middle * (to - from);
    (distance(near_a, p) <= distance(near_b, p) ? low : high) = middle;
  }
  if (low < kLeastShare || low > 1 - kLeastShare) return std::nullopt;
  return Cut{low, between(charts.mesh(), near_a, near_b, from + low * (to - from))};
}

class SeamCutter {
 public:
  SeamCutter(const Charts& charts, const Mesh& target, const SurfaceMap& target_to_source)
      : charts_(charts), target_(target), result_{{target.vertices, {}}, target_to_source} {}

  MappedMesh run() {
    for (const Face& face : target_.faces) cut_face(face);
    return std::move(result_);
  }

 private:
  static constexpr int kUncut = -1;

  /// The new vertex on the edge, `kUncut` if there is none.
  int edge_vertex(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    const std::uint64_t key = std::uint64_t(low) * target_.vertices.size() + high;
    const auto [entry, is_new] = vertex_on_edge_.try_emplace(key, kUncut);
    if (is_new) entry->second = make_vertex(low, high);
    return entry->second;
  }

  int make_vertex(int a, int b) {
    if (result_.map[a].face == kNoFace || result_.map[b].face == kNoFace) return kUncut;
    // Both sides of a split edge begin at the same end.
    const auto& p = target_.vertices;
    if (std::lexicographical_compare(p[b].begin(), p[b].end(), p[a].begin(), p[a].end()))
      std::swap(a, b);
    const std::optional<Cut> cut = find_cut(charts_, result_.map[a], result_.map[b]);
    if (!cut) return kUncut;
    result_.mesh.vertices.emplace_back((1 - cut->share) * p[a] + cut->share * p[b]);
    result_.map.push_back(cut->point);
    return result_.mesh.num_vertices() - 1;
  }

  void cut_face(const Face& face) {
    // Corner k, and behind it the vertex on the edge to the next one.
    std::array<int, 3> on_edge;
    for (int k = 0; k < 3; ++k) on_edge[k] = edge_vertex(face[k], face[(k + 1) % 3]);
    const auto cuts = 3 - std::ranges::count(on_edge, kUncut);
    // Turn the face so that the edges that matter come first.
    int first = 0;
    if (cuts == 1)
      first = static_cast<int>(std::ranges::find_if(on_edge, is_cut) - on_edge.begin());
    if (cuts == 2)
      first = static_cast<int>(std::ranges::find(on_edge, kUncut) - on_edge.begin()) + 1;
    const auto turned = [&](const std::array<int, 3>& triple) {
      return std::array{triple[first % 3], triple[(first + 1) % 3], triple[(first + 2) % 3]};
    };
    const auto [a, b, c] = turned(face);
    const auto [ab, bc, ca] = turned(on_edge);
    if (cuts == 0) add({{a, b, c}});
    if (cuts == 1) add({{a, ab, c}, {ab, b, c}});
    if (cuts == 2) add({{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
    if (cuts == 3) add({{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }

  static bool is_cut(int vertex) { return vertex != kUncut; }

  void add(std::initializer_list<Face> faces) {
    result_.mesh.faces.insert(result_.mesh.faces.end(), faces);
  }

  const Charts& charts_;
  const Mesh& target_;
  MappedMesh result_;
  std::unordered_map<std::uint64_t, int> vertex_on_edge_;
};

}  // namespace

MappedMesh cut_along_seams(const Charts& charts, const Mesh& target,
                           const SurfaceMap& target_to_source) {
  return SeamCutter(charts, target, target_to_source).run();
}

}  // namespace isomatch::transfer
