// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "measure/spread_matches.h"

#include <algorithm>

namespace isomatch {
namespace {

/// The first match of each source vertex.
std::vector<Match> first_matches(const Correspondence& matches) {
  std::vector<Match> first = matches;
  const auto same_source = [](const Match& a, const Match& b) { return a.source == b.source; };
  first.erase(std::unique(first.begin(), first.end(), same_source), first.end());
  return first;
}

}  // namespace

std::vector<Match> evenly_spaced_matches(const MetricSurface& source, const SurfaceMatches& matches,
                                         int count) {
  if (std::ssize(*matches) <= count) return *matches;
  const std::vector<Match> candidates = first_matches(*matches);
  std::vector<int> vertices;
  for (const Match& match : candidates) vertices.push_back(match.source);
  const int extremity = farthest_points(source.graph(), vertices, 2).back();
  std::vector<Match> chosen;
  for (int place : farthest_points(source.graph(), vertices, count, extremity))
    chosen.push_back(candidates[place]);
  return chosen;
}

}  // namespace isomatch
