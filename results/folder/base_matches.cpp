// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/base_matches.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace isomatch::results {
namespace {

void sort_by_match(MeasuredMatches& measured) {
  std::vector<std::size_t> order(measured.matches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return measured.matches[i]; });
  MeasuredMatches sorted;
  for (std::size_t i : order) {
    sorted.matches.push_back(measured.matches[i]);
    sorted.distortion.push_back(measured.distortion[i]);
  }
  measured = std::move(sorted);
}

}  // namespace

MeasuredMatches between_vertices(const MatchInputs& inputs, const PaperResult& result,
                                 const Correspondence& matches,
                                 const std::vector<double>& distortion) {
  MeasuredMatches measured;
  for (std::size_t m = 0; m < matches.size(); ++m) {
    for (int s : inputs.source.shape.copies(result.source_bases[matches[m].source])) {
      for (int t : inputs.target.shape.copies(result.target_bases[matches[m].target])) {
        measured.matches.push_back({s, t});
        measured.distortion.push_back(distortion[m]);
      }
    }
  }
  sort_by_match(measured);
  return measured;
}

}  // namespace isomatch::results
