// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "measure/checks.h"
#include "parallel.h"

namespace isomatch {
namespace {

/// Fields held at a time: enough to keep the threads busy, little memory for large meshes.
constexpr int kFieldsAtATime = 32;
/// Matches that one thread takes at a time. They lie together on both surfaces, so that what they
/// look up in a field stays in the cache.
constexpr int kMatchesAtATime = 1024;

/// The first match of each source vertex.
std::vector<Match> first_matches(const Correspondence& matches) {
  std::vector<Match> first = matches;
  const auto same_source = [](const Match& a, const Match& b) { return a.source == b.source; };
  first.erase(std::unique(first.begin(), first.end(), same_source), first.end());
  return first;
}

/// |g(s, s_l) - g(t, t_l)| of every match, summed over the entries of a list block by block.
class DistortionSum {
 public:
  DistortionSum(const Shape& source, const Shape& target, const Correspondence& matches)
      : source_(source), target_(target), matches_(matches), sums_(matches.size(), 0.0) {}

  void add(std::span<const Match> list, const Context& context);
  const std::vector<double>& sums() const { return sums_; }

 private:
  void add_entry(std::span<const float> source_field, std::span<const float> target_field,
                 std::size_t first, std::size_t last);

  const Shape& source_;
  const Shape& target_;
  const Correspondence& matches_;
  std::vector<double> sums_;
};

void DistortionSum::add(std::span<const Match> list, const Context& context) {
  std::vector<int> sources, targets;
  for (const Match& match : list) {
    sources.push_back(match.source);
    targets.push_back(match.target);
  }
  const std::vector<float> source_fields = geodesic_fields(source_.graph, sources, context);
  const std::vector<float> target_fields = geodesic_fields(target_.graph, targets, context);
  const std::size_t ns = source_.num_vertices(), nt = target_.num_vertices();
  const std::size_t blocks = (matches_.size() + kMatchesAtATime - 1) / kMatchesAtATime;
  parallel_for(static_cast<std::ptrdiff_t>(blocks), context, [&](std::ptrdiff_t block) {
    const std::size_t first = block * kMatchesAtATime;
    const std::size_t last = std::min(first + kMatchesAtATime, matches_.size());
    for (std::size_t l = 0; l < list.size(); ++l)
      add_entry({&source_fields[l * ns], ns}, {&target_fields[l * nt], nt}, first, last);
  });
}

void DistortionSum::add_entry(std::span<const float> source_field,
                              std::span<const float> target_field, std::size_t first,
                              std::size_t last) {
  for (std::size_t m = first; m < last; ++m) {
    const double source_distance = source_field[matches_[m].source] / source_.max_geodesic;
    const double target_distance = target_field[matches_[m].target] / target_.max_geodesic;
    sums_[m] += std::abs(source_distance - target_distance);
  }
}

/// Divides by the size of xi', which does not contain the match itself.
std::vector<double> averages(const Correspondence& matches, std::vector<Match> list,
                             std::vector<double> sums) {
  std::ranges::sort(list);
  for (std::size_t m = 0; m < matches.size(); ++m) {
    const bool listed = std::ranges::binary_search(list, matches[m]);
    const auto others = std::ssize(list) - (listed ? 1 : 0);
    sums[m] /= static_cast<double>(std::max<std::ptrdiff_t>(1, others));
  }
  return sums;
}

}  // namespace

std::vector<Match> evenly_spaced_matches(const Shape& source, const Correspondence& matches,
                                         int count) {
  if (std::ssize(matches) <= count) return matches;
  const std::vector<Match> candidates = first_matches(matches);
  std::vector<int> vertices;
  for (const Match& match : candidates) vertices.push_back(match.source);
  const int extremity = farthest_points(source.graph, vertices, 2).back();
  std::vector<Match> chosen;
  for (int place : farthest_points(source.graph, vertices, count, extremity))
    chosen.push_back(candidates[place]);
  return chosen;
}

void DistortionOptions::validate() const {
  if (list_size < 1) throw InvalidInput("list_size must be at least 1");
}

IsometricDistortion isometric_distortion(const Shape& source, const Shape& target,
                                         const Correspondence& matches,
                                         const DistortionOptions& options, const Context& context) {
  options.validate();
  check_matches(source, target, matches);
  if (matches.empty()) return {};
  const std::vector<Match> list = evenly_spaced_matches(source, matches, options.list_size);
  DistortionSum sum(source, target, matches);
  for (std::size_t first = 0; first < list.size(); first += kFieldsAtATime) {
    context.report(static_cast<double>(first) / static_cast<double>(list.size()), "distortion");
    sum.add(
        std::span(list).subspan(first, std::min<std::size_t>(kFieldsAtATime, list.size() - first)),
        context);
  }
  IsometricDistortion result;
  result.per_match = averages(matches, list, sum.sums());
  result.maximum = *std::ranges::max_element(result.per_match);
  result.mean = std::accumulate(result.per_match.begin(), result.per_match.end(), 0.0) /
                static_cast<double>(matches.size());
  return result;
}

}  // namespace isomatch
