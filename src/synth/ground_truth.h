// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <vector>

#include "isomatch/context.h"
#include "synth/body.h"

namespace isomatch {

template <int Dimension>
class KdTree;

}  // namespace isomatch

namespace isomatch::synth {

/// Finds, among points of a skin at rest, the one nearest to others on the skin.
class SurfaceLookup {
 public:
  /// Keeps references to all arguments. O(N log N).
  SurfaceLookup(const Body& body, const std::vector<Point>& rest, const Context& context);
  ~SurfaceLookup();

  /// Index of the nearest point that lies on the same side of the skin, so that the search does not
  /// jump through a thin part; ties to the lower index.
  std::vector<int> nearest(const std::vector<Point>& queries) const;

 private:
  int nearest(const Point& query) const;

  const Body* body_;
  const std::vector<Point>* rest_;
  const Context* context_;
  std::unique_ptr<KdTree<3>> tree_;
};

}  // namespace isomatch::synth
