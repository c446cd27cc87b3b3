// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/input_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"

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

void check_landmark(const char* side, const Surface& surface, int vertex) {
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= surface.surface_vertex.size())
    throw InvalidInput(fmt::format("{} vertex {} is out of range", side, vertex));
  if (surface.surface_vertex[vertex] == kNoVertex)
    throw InvalidInput(
        fmt::format("{} vertex {} is not on the surface that is matched", side, vertex));
}

void check_sources_differ(const std::vector<Match>& pairs) {
  std::vector<int> sources;
  for (const Match& pair : pairs) sources.push_back(pair.source);
  std::ranges::sort(sources);
  const auto twice = std::ranges::adjacent_find(sources);
  if (twice != sources.end())
    throw InvalidInput(fmt::format("source vertex {} has two landmarks", *twice));
}

}  // namespace

InputNumbers::InputNumbers(const MatchInputs& inputs, const PaperResult& result)
    : inputs_(inputs),
      result_(result),
      source_(input_vertices(inputs.source.surface)),
      target_(input_vertices(inputs.target.surface)) {}

MeasuredMatches InputNumbers::translate(const Correspondence& matches,
                                        const std::vector<double>& distortion) const {
  MeasuredMatches result;
  for (std::size_t m = 0; m < matches.size(); ++m) {
    for (int s : source_[result_.source_bases[matches[m].source]]) {
      for (int t : target_[result_.target_bases[matches[m].target]]) {
        result.matches.push_back({s, t});
        result.distortion.push_back(distortion[m]);
      }
    }
  }
  sort_by_match(result);
  return result;
}

VertexMap InputNumbers::source_to_target() const {
  VertexMap map(inputs_.source.mesh.vertices.size(), kUnmatched);
  for (std::size_t v = 0; v < source_.size(); ++v) {
    const int image = result_.source_to_target[v];
    if (image == kUnmatched) continue;
    for (int s : source_[v]) map[s] = target_[image].front();
  }
  return map;
}

SurfaceMap input_points(const MatchInput& from, const MatchInput& onto, const SurfaceMap& map) {
  return input_map(from.surface, onto.surface, map);
}

Correspondence input_matches(const MatchInputs& inputs, const TrackedMap& map) {
  const auto sources = input_vertices(inputs.source.surface);
  const auto targets = input_vertices(inputs.target.surface);
  Correspondence result;
  for (const Match& match : matches(inputs.source.surface, inputs.target.surface, map)) {
    for (int s : sources[match.source])
      for (int t : targets[match.target]) result.push_back({s, t});
  }
  std::ranges::sort(result);
  return result;
}

Correspondence surface_landmarks(const MatchInputs& inputs, const std::vector<Match>& pairs) {
  const Surface& source = inputs.source.surface;
  const Surface& target = inputs.target.surface;
  for (const Match& pair : pairs) {
    check_landmark("source", source, pair.source);
    check_landmark("target", target, pair.target);
  }
  check_sources_differ(pairs);
  Correspondence landmarks = surface_matches(source, target, pairs);
  const auto twice = std::ranges::adjacent_find(landmarks, {}, &Match::source);
  if (twice != landmarks.end())
    throw InvalidInput(fmt::format("copies of source vertex {} on a seam have different landmarks",
                                   source.input_vertex[twice->source]));
  return landmarks;
}

}  // namespace isomatch::results
