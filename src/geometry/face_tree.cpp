// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/face_tree.h"

#include <algorithm>

#include "geometry/closest_point.h"

namespace isomatch {

FaceTree::FaceTree(const Mesh& mesh) : mesh_(mesh) {
  std::vector<Point> middles(mesh.faces.size());
  for (int f = 0; f < mesh.num_faces(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    middles[f] = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
    if (middles[f].allFinite()) order_.push_back(f);
  }
  if (!order_.empty()) build(middles, 0, static_cast<int>(order_.size()));
}

void FaceTree::build(const std::vector<Point>& middles, int first, int last) {
  constexpr int kLeaf = 4;  // Fewer faces cost more in boxes than they save.
  const std::size_t node = nodes_.size();
  nodes_.push_back({{}, first, last});
  for (int i = first; i < last; ++i)
    for (int v : mesh_.faces[order_[i]]) nodes_[node].box.extend(mesh_.vertices[v]);
  if (last - first <= kLeaf) return;
  Eigen::Index axis = 0;
  nodes_[node].box.sizes().maxCoeff(&axis);
  const int middle = first + (last - first) / 2;
  const auto begin = order_.begin();
  std::nth_element(begin + first, begin + middle, begin + last,
                   [&](int f, int g) { return middles[f][axis] < middles[g][axis]; });
  build(middles, first, middle);
  nodes_[node].second_child = static_cast<int>(nodes_.size());
  build(middles, middle, last);
}

bool FaceTree::is_within(const Point& p, double distance) const {
  const double squared = distance * distance;
  std::vector<int> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const int at = open.back();
    const Node& node = nodes_[at];
    open.pop_back();
    if (node.box.squaredExteriorDistance(p) > squared) continue;
    if (node.second_child != 0) {
      open.insert(open.end(), {node.second_child, at + 1});
      continue;
    }
    for (int i = node.first; i < node.last; ++i)
      if (closest_point(mesh_, order_[i], p).squared_distance <= squared) return true;
  }
  return false;
}

}  // namespace isomatch
