// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "measure/checks.h"

namespace isomatch {
namespace {

int surface_vertex(const Surface& surface, int input_vertex) {
  check_index(input_vertex, surface.surface_vertex.size());
  return surface.surface_vertex[input_vertex];
}

}  // namespace

Correspondence surface_matches(const Surface& source, const Surface& target,
                               const Correspondence& matches) {
  Correspondence result;
  for (const Match& match : matches) {
    const int s = surface_vertex(source, match.source);
    const int t = surface_vertex(target, match.target);
    if (s != kNoVertex && t != kNoVertex) result.push_back({s, t});
  }
  std::ranges::sort(result);
  const auto repeated = std::ranges::unique(result);
  result.erase(repeated.begin(), repeated.end());
  return result;
}

GroundTruth surface_truth(const Surface& source, const Surface& target,
                          std::span<const int> source_vertices,
                          std::span<const int> target_vertices) {
  if (source_vertices.size() != target_vertices.size())
    throw InvalidInput(fmt::format("the ground truth has {} points on the source, {} on the target",
                                   source_vertices.size(), target_vertices.size()));
  GroundTruth truth;
  for (std::size_t i = 0; i < source_vertices.size(); ++i) {
    const int s = surface_vertex(source, source_vertices[i]);
    const int t = surface_vertex(target, target_vertices[i]);
    if (s == kNoVertex || t == kNoVertex) continue;
    truth.source.push_back(s);
    truth.target.push_back(t);
  }
  return truth;
}

}  // namespace isomatch
