// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/drawing/pair_confidence.h"

#include <limits>

#include "results/drawing/nearest_images.h"

namespace isomatch::results {
namespace {

constexpr float kNoPoint = std::numeric_limits<float>::quiet_NaN();

std::vector<float> own_confidence(const ResultMap& map, const std::vector<bool>& matched) {
  std::vector<float> own = map.target_confidence;
  for (std::size_t t = 0; t < own.size(); ++t)
    if (!matched[t]) own[t] = kNoPoint;
  return own;
}

std::vector<float> carried_confidence(const MatchResult& result, const ResultMap& map,
                                      const std::vector<bool>& matched) {
  std::vector<float> carried;
  for (int source : nearest_images(images(result.target, map), map.source_to_target,
                                   result.target.vertices, matched))
    carried.push_back(source == kUnmatched ? kNoPoint : map.source_confidence[source]);
  return carried;
}

}  // namespace

std::optional<PairConfidence> pair_confidence(const MatchResult& result, const ResultMap& map,
                                              const std::vector<bool>& matched) {
  if (map.source_confidence.empty()) return {};
  PairConfidence confidence{map.source_confidence, {}};
  for (std::size_t v = 0; v < confidence.source.size(); ++v)
    if (!map.is_matched(static_cast<int>(v))) confidence.source[v] = kNoPoint;
  confidence.target = map.target_confidence.empty() ? carried_confidence(result, map, matched)
                                                    : own_confidence(map, matched);
  return confidence;
}

}  // namespace isomatch::results
