// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <compare>
#include <span>
#include <utility>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// Lists of integers, one per index, stored in one block (compressed sparse rows).
class IndexLists {
 public:
  IndexLists() = default;
  /// `offsets` has one more entry than there are lists; list i is `values[offsets[i],
  /// offsets[i+1])`.
  IndexLists(std::vector<int> offsets, std::vector<int> values)
      : offsets_(std::move(offsets)), values_(std::move(values)) {}

  int size() const { return static_cast<int>(offsets_.size()) - 1; }
  std::span<const int> operator[](int index) const {
    return {values_.data() + offsets_[index], values_.data() + offsets_[index + 1]};
  }

 private:
  std::vector<int> offsets_{0};
  std::vector<int> values_;
};

inline constexpr int kNoVertex = -1;

bool has_repeated_vertex(const Face& face);

/// One face's side of an edge: the edge's ends in ascending order, the face, and the corner of the
/// face that is opposite the edge.
struct EdgeSide {
  int low, high;
  int face, corner;

  bool same_edge(const EdgeSide& other) const { return low == other.low && high == other.high; }
  auto operator<=>(const EdgeSide&) const = default;
};

/// The sides of all edges in ascending order, so that the sides of one edge are adjacent. Faces
/// with a repeated vertex have none. O(N log N) at worst, O(N) as a rule.
std::vector<EdgeSide> sorted_edge_sides(const Mesh& mesh);

/// Calls `visit` with the `std::span<const Side>` of each edge: runs of sides of which `same_edge`
/// holds, in the order of `sorted_sides` (a contiguous range).
template <class Sides, class Visit>
void for_each_edge(const Sides& sorted_sides, const Visit& visit) {
  const std::span sides(sorted_sides);
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].same_edge(sides[first])) ++last;
    visit(sides.subspan(first, last - first));
    first = last;
  }
}

/// The faces around each vertex, in ascending order. O(N).
IndexLists vertex_faces(const Mesh& mesh);

/// For each face, the face across the edge opposite corner 0, 1 and 2. `kNoFace` where the edge is
/// a boundary or belongs to more than two faces. Orientation plays no part. O(N log N).
inline constexpr int kNoFace = -1;
std::vector<std::array<int, 3>> face_neighbours(const Mesh& mesh);

/// Component label of each vertex, numbered from 0 in the order of their lowest vertex. Vertices
/// are connected if they share a face; an unreferenced vertex is a component of its own. O(N).
std::vector<int> vertex_components(const Mesh& mesh);

}  // namespace isomatch
