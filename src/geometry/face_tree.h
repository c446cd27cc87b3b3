// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// A tree of boxes around the faces of a mesh, to which it keeps a reference. Faces with
/// coordinates that are not finite are left out. Building costs O(N log N), a search O(log N) as a
/// rule. Searches may run in parallel.
class FaceTree {
 public:
  explicit FaceTree(const Mesh& mesh);

  /// Whether a face is no farther than `distance` from `p`.
  bool is_within(const Point& p, double distance) const;

 private:
  /// Of the faces in `order_` from `first` to before `last`; leaves have no second child.
  struct Node {
    Eigen::AlignedBox3d box;
    int first, last;
    int second_child = 0;
  };

  void build(const std::vector<Point>& middles, int first, int last);

  const Mesh& mesh_;
  std::vector<int> order_;
  /// The first child of a node follows it.
  std::vector<Node> nodes_;
};

}  // namespace isomatch
