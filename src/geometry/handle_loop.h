// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// Finds loops of edges that cut a handle of a mesh open: those that do not fall into two sides.
/// Holes count as filled. By the tree and cotree of each root (Eppstein 2003, Erickson and
/// Whittlesey 2005).
class HandleLoops {
 public:
  /// `weights` of the vertices, positive: an edge costs its length times the mean of its ends'.
  HandleLoops(const Mesh& mesh, std::span<const double> weights);

  /// How many handles there are, 0 if an edge has more than two faces. O(1).
  int num_handles() const { return num_handles_; }

  struct Loop {
    /// In order.
    std::vector<int> vertices;
    double cost = 0;
  };
  /// The loop of the least cost among those that are shortest through, or seen from, one of the
  /// roots; without vertices if there is none. O(N log N) for each root.
  Loop cheapest(std::span<const int> roots) const;

 private:
  struct Edge {
    int a, b;
    /// Faces, or what fills a hole.
    int left, right;
    double cost;
  };
  struct Half {
    int to;
    int edge;
  };
  struct Tree;
  Tree shortest_paths(int root) const;
  std::vector<int> crossing_edges(const Tree& tree) const;
  Loop loop_through(const Tree& tree, const Edge& edge) const;

  int num_vertices_, num_sides_, num_handles_ = 0;
  std::vector<Edge> edges_;
  std::vector<int> offsets_;
  std::vector<Half> halves_;
};

}  // namespace isomatch
