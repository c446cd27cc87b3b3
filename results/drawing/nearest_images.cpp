// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/drawing/nearest_images.h"

#include <array>

#include "geometry/kd_tree.h"

namespace isomatch::results {

VertexMap nearest_images(const std::vector<Point>& images, const VertexMap& map,
                         const std::vector<Point>& targets, const std::vector<bool>& reached) {
  std::vector<Point> places;
  std::vector<int> sources;
  for (std::size_t v = 0; v < images.size(); ++v) {
    if (map[v] == kUnmatched) continue;
    places.push_back(images[v]);
    sources.push_back(static_cast<int>(v));
  }
  VertexMap nearest(targets.size(), kUnmatched);
  if (places.empty()) return nearest;
  const KdTree<3> tree(places);
  for (std::size_t t = 0; t < targets.size(); ++t) {
    std::array<int, 1> place{};
    if (reached[t] && tree.nearest(targets[t], place) > 0) nearest[t] = sources[place[0]];
  }
  return nearest;
}

}  // namespace isomatch::results
