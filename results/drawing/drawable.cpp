// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/drawing/drawable.h"

#include "isomatch/shape/diagnosis.h"

namespace isomatch::results {
namespace {

/// Puts each of `points` where the one that stands for it is.
void replace(const std::vector<int>& places, std::vector<Point>& points) {
  for (std::size_t v = 0; v < points.size(); ++v) points[v] = points[places[v]];
}

}  // namespace

void make_drawable(Mesh& mesh) { replace(stand_ins(mesh), mesh.vertices); }

void make_drawable(MatchResult& result) {
  const std::vector<int> places = stand_ins(result.source);
  for (ResultMap& map : result.maps) replace(places, map.registered);
  make_drawable(result.source);
  make_drawable(result.target);
}

}  // namespace isomatch::results
