// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "measure/spread_matches.h"
#include "parallel.h"
#include "shape/prepared_shape.h"

namespace isomatch {
namespace {

/// Fields held at a time: enough to keep the threads busy, little memory for large meshes.
constexpr int kFieldsAtATime = 32;
/// Matches that one thread takes at a time. They lie together on both surfaces, so that what they
/// look up in a field stays in the cache.
constexpr int kMatchesAtATime = 1024;

/// |g(s, s_l) - g(t, t_l)| of every match, summed over the entries of a list block by block.
class DistortionSum {
 public:
  DistortionSum(const MetricSurface& source, const MetricSurface& target,
                const Correspondence& matches)
      : source_(source), target_(target), matches_(matches), sums_(matches.size(), 0.0) {}

  void add(std::span<const Match> list, const Context& context);
  const std::vector<double>& sums() const { return sums_; }

 private:
  void add_entry(std::span<const float> source_field, std::span<const float> target_field,
                 std::size_t first, std::size_t last);

  const MetricSurface& source_;
  const MetricSurface& target_;
  const Correspondence& matches_;
  std::vector<double> sums_;
};

void DistortionSum::add(std::span<const Match> list, const Context& context) {
  std::vector<int> sources, targets;
  for (const Match& match : list) {
    sources.push_back(match.source);
    targets.push_back(match.target);
  }
  const std::vector<float> source_fields = geodesic_fields(source_.graph(), sources, context);
  const std::vector<float> target_fields = geodesic_fields(target_.graph(), targets, context);
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
    const double source_distance = source_field[matches_[m].source] / source_.max_geodesic();
    const double target_distance = target_field[matches_[m].target] / target_.max_geodesic();
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

/// The distortion of matches between surfaces, in their order.
std::vector<double> measured(const MetricSurface& source, const MetricSurface& target,
                             const SurfaceMatches& matches, int list_size, const Context& context) {
  const std::vector<Match> list = evenly_spaced_matches(source, matches, list_size);
  DistortionSum sum(source, target, *matches);
  for (std::size_t first = 0; first < list.size(); first += kFieldsAtATime) {
    context.report(static_cast<double>(first) / static_cast<double>(list.size()), "distortion");
    sum.add(
        std::span(list).subspan(first, std::min<std::size_t>(kFieldsAtATime, list.size() - first)),
        context);
  }
  return averages(*matches, list, sum.sums());
}

/// `values` of the matches between surfaces for those that the caller gave.
std::vector<double> of_input(const Correspondence& matches, const Surface& source,
                             const Surface& target, const SurfaceMatches& on_surfaces,
                             const std::vector<double>& values) {
  std::vector<double> result;
  for (const Match& match : matches) {
    const Match measured{surface_vertex(source, match.source),
                         surface_vertex(target, match.target)};
    const auto place = std::ranges::lower_bound(*on_surfaces, measured);
    const bool known = place != on_surfaces->end() && *place == measured;
    result.push_back(known ? values[place - on_surfaces->begin()]
                           : std::numeric_limits<double>::quiet_NaN());
  }
  return result;
}

}  // namespace

void DistortionOptions::validate() const {
  if (list_size < 1) throw InvalidInput("list_size must be at least 1");
}

IsometricDistortion isometric_distortion(const Shape& source, const Shape& target,
                                         const Correspondence& matches,
                                         const DistortionOptions& options, const Context& context) {
  options.validate();
  const Surface& from = *source.prepared().surface();
  const Surface& onto = *target.prepared().surface();
  const SurfaceMatches between = on_surfaces(from, onto, matches);
  IsometricDistortion result;
  if (!between->empty()) {
    const std::vector<double> d_iso =
        measured(source.prepared().metric(context), target.prepared().metric(context), between,
                 options.list_size, context);
    result.matches = static_cast<int>(d_iso.size());
    result.maximum = *std::ranges::max_element(d_iso);
    result.mean =
        std::accumulate(d_iso.begin(), d_iso.end(), 0.0) / static_cast<double>(d_iso.size());
    result.per_match = of_input(matches, from, onto, between, d_iso);
  } else {
    result.per_match.assign(matches.size(), std::numeric_limits<double>::quiet_NaN());
  }
  return result;
}

}  // namespace isomatch
