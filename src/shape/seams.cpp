// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/seams.h"

#include <algorithm>
#include <array>
#include <compare>
#include <span>
#include <utility>

#include "geometry/bucket_sort.h"
#include "geometry/disjoint_sets.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

/// Vertex pairs (first with first, second with second) of two boundary edges that coincide.
struct Join {
  std::array<int, 2> first, second;
};

/// A boundary edge by where it lies: the position numbers of its ends, ascending, and of the
/// opposite corner of its face.
struct PlacedEdge {
  int low_place, high_place, apex_place;
  int component, face;
  int low_vertex, high_vertex;

  bool same_edge(const PlacedEdge& other) const {
    return low_place == other.low_place && high_place == other.high_place;
  }
  auto operator<=>(const PlacedEdge&) const = default;
};

std::vector<EdgeSide> boundary_sides(std::span<const EdgeSide> sides) {
  std::vector<EdgeSide> boundary;
  for_each_edge(sides, [&](std::span<const EdgeSide> edge) {
    if (edge.size() == 1) boundary.push_back(edge[0]);
  });
  return boundary;
}

/// The same number for vertices at the same position.
std::vector<int> number_positions(const Mesh& mesh) {
  std::vector<int> place(mesh.vertices.size(), 0);
  for (int v = 1; v < mesh.num_vertices(); ++v)
    place[v] = place[v - 1] + (mesh.vertices[v] != mesh.vertices[v - 1]);
  return place;
}

std::vector<PlacedEdge> placed_edges(const Mesh& mesh, std::span<const EdgeSide> boundary) {
  const std::vector<int> place = number_positions(mesh);
  const std::vector<int> component = vertex_components(mesh);
  return bucket_sorted<PlacedEdge>(mesh.num_vertices(), [&](const auto& sink) {
    for (const EdgeSide& side : boundary) {
      int low = side.low, high = side.high;
      if (place[low] > place[high]) std::swap(low, high);
      const int apex = mesh.faces[side.face][side.corner];
      sink(place[low],
           PlacedEdge{place[low], place[high], place[apex], component[low], side.face, low, high});
    }
  });
}

std::vector<Join> find_joins(std::span<const PlacedEdge> edges) {
  std::vector<Join> joins;
  for_each_edge(edges, [&](std::span<const PlacedEdge> coinciding) {
    const PlacedEdge& a = coinciding.front();
    const auto b = std::ranges::find_if(
        coinciding, [&](const PlacedEdge& edge) { return edge.apex_place != a.apex_place; });
    const bool two = b != coinciding.end() && b->apex_place == coinciding.back().apex_place;
    if (two) joins.push_back({{a.low_vertex, b->low_vertex}, {a.high_vertex, b->high_vertex}});
  });
  return joins;
}

/// For each vertex the lowest of those that `joins` make one with it.
std::vector<int> joined_vertices(int num_vertices, std::span<const Join> joins) {
  DisjointSets sets(num_vertices);
  for (const Join& join : joins) {
    sets.join(join.first[0], join.first[1]);
    sets.join(join.second[0], join.second[1]);
  }
  std::vector<int> joined(num_vertices);
  for (int v = 0; v < num_vertices; ++v) joined[v] = sets.find(v);
  return joined;
}

/// An edge side as it would be after joining: ends and opposite corner, and the edge it was before.
struct JoinedSide {
  int low, high, apex;
  int old_low, old_high;

  bool same_edge(const JoinedSide& other) const { return low == other.low && high == other.high; }
  bool same_old_edge(const JoinedSide& other) const {
    return old_low == other.old_low && old_high == other.old_high;
  }
  auto operator<=>(const JoinedSide&) const = default;
};

/// The sides with an end that joins, so that edges without a change are not looked at again.
std::vector<JoinedSide> joined_sides(const Mesh& mesh, std::span<const EdgeSide> sides,
                                     std::span<const int> joined) {
  std::vector<char> changes(mesh.vertices.size(), 0);
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    if (joined[v] != v) changes[v] = changes[joined[v]] = 1;
  }
  return bucket_sorted<JoinedSide>(mesh.num_vertices(), [&](const auto& sink) {
    for (const EdgeSide& side : sides) {
      if (!changes[side.low] && !changes[side.high]) continue;
      const auto [low, high] = std::minmax(joined[side.low], joined[side.high]);
      const int apex = joined[mesh.faces[side.face][side.corner]];
      sink(low, JoinedSide{low, high, apex, side.low, side.high});
    }
  });
}

/// True if joining brings too many faces to this edge or makes two of them equal.
bool is_conflict(std::span<const JoinedSide> edge) {
  const bool mixed = !std::ranges::all_of(
      edge, [&](const JoinedSide& side) { return side.same_old_edge(edge[0]); });
  if (mixed && edge.size() > 2) return true;
  return std::ranges::adjacent_find(edge, {}, &JoinedSide::apex) != edge.end();
}

/// Takes back the joins at the ends of edges in conflict. Splitting a vertex only ever takes faces
/// away from an edge, hence one pass settles all conflicts.
void drop_conflicting(std::vector<Join>& joins, std::span<const JoinedSide> sides,
                      std::span<const int> joined) {
  std::vector<char> conflict(joined.size(), 0);
  for_each_edge(sides, [&](std::span<const JoinedSide> edge) {
    if (is_conflict(edge)) conflict[edge[0].low] = conflict[edge[0].high] = 1;
  });
  std::erase_if(joins, [&](const Join& join) {
    return conflict[joined[join.first[0]]] || conflict[joined[join.second[0]]];
  });
}

}  // namespace

Seams join_seams(const Mesh& mesh) {
  const std::vector<EdgeSide> sides = sorted_edge_sides(mesh);
  std::vector<Join> joins = find_joins(placed_edges(mesh, boundary_sides(sides)));
  std::vector<int> joined = joined_vertices(mesh.num_vertices(), joins);
  drop_conflicting(joins, joined_sides(mesh, sides, joined), joined);
  joined = joined_vertices(mesh.num_vertices(), joins);
  return {std::move(joined), static_cast<int>(joins.size())};
}

}  // namespace isomatch
