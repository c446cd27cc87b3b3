// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/drawing/pair_confidence.h"

#include <limits>

#include "results/drawing/nearest_images.h"

namespace isomatch::results {
namespace {

constexpr float kNoPoint = std::numeric_limits<float>::quiet_NaN();

std::vector<float> source_confidence(const ResultMap& map) {
  std::vector<float> confidence = map.source_confidence;
  for (std::size_t v = 0; v < confidence.size(); ++v)
    if (!map.is_matched(static_cast<int>(v))) confidence[v] = kNoPoint;
  return confidence;
}

std::vector<float> target_confidence(const MatchResult& result, const ResultMap& map,
                                     const std::vector<bool>& matched) {
  const VertexMap back = nearest_images(images(result.target, map), map.source_to_target,
                                        result.target.vertices, matched);
  std::vector<float> confidence(back.size(), kNoPoint);
  for (std::size_t t = 0; t < back.size(); ++t) {
    if (back[t] == kUnmatched) continue;
    const float own = map.target_confidence.empty() ? 0 : map.target_confidence[t];
    confidence[t] = own > 0 ? own : map.source_confidence[back[t]];
  }
  return confidence;
}

}  // namespace

std::optional<PairConfidence> pair_confidence(const MatchResult& result, const ResultMap& map,
                                              const std::vector<bool>& matched) {
  if (map.source_confidence.empty()) return {};
  return PairConfidence{source_confidence(map), target_confidence(result, map, matched)};
}

}  // namespace isomatch::results
