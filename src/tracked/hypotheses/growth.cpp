// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/growth.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "wide_vectors.h"

namespace isomatch::tracked {
namespace {

/// What two distances differ by, each of which is between a least and a most on the whole shape;
/// what may be due to what is missing counts as `doubt` says.
inline float doubted(float least_a, float most_a, float least_b, float most_b, float doubt) {
  const float sure = std::max({0.0F, least_b - most_a, least_a - most_b});
  return sure + doubt * (std::abs(most_a - most_b) - sure);
}

/// Adds to each of `costs` what two distances differ by.
ISOMATCH_WIDE_VECTORS void add_differences(const float* distances, std::size_t count,
                                           float expected, float* costs) {
  for (std::size_t t = 0; t < count; ++t) costs[t] += std::abs(expected - distances[t]);
}

}  // namespace

Growth::Growth(const NodeDirections& source, int source_count, const NodeDirections& target,
               int target_count, const GrowthOptions& options)
    : source_(source),
      target_(target),
      options_(options),
      source_count_(std::min(source_count, source.size())),
      target_count_(std::min(target_count, target.size())),
      oriented_(options.orientation && source.oriented() && target.oriented()),
      partial_(options.doubt < 1),
      nearest_(source_count_),
      cost_(target_count_) {
  for (int i = 0; i < source_count_; ++i) {
    nearest_[i].resize(source_count_);
    std::iota(nearest_[i].begin(), nearest_[i].end(), 0);
    std::ranges::stable_sort(nearest_[i], {}, [&](int j) { return source.distance(i, j); });
  }
}

/// Fills `cost_` with the mean distortion of each target against all other matches.
void Growth::accumulate(int source, const std::vector<int>& map) {
  std::ranges::fill(cost_, 0.0F);
  int count = 0;
  for (int j = 0; j < source_count_; ++j) {
    if (map[j] == kUnmatched || j == source) continue;
    const float most = source_.distance(source, j);
    const float* distances = target_.distances_from(map[j]).data();
    if (partial_) {
      const float least = source_.least_distances_from(source)[j];
      const float* least_distances = target_.least_distances_from(map[j]).data();
      for (std::size_t t = 0; t < cost_.size(); ++t)
        cost_[t] += doubted(least, most, least_distances[t], distances[t], options_.doubt);
    } else {
      add_differences(distances, cost_.size(), most, cost_.data());
    }
    ++count;
  }
  for (float& cost : cost_) cost /= static_cast<float>(std::max(1, count));
}

float Growth::difference(int source, int other, int target, int other_target) const {
  const float a = source_.distance(source, other), b = target_.distance(target, other_target);
  if (!partial_) return std::abs(a - b);
  return doubted(source_.least_distances_from(source)[other], a,
                 target_.least_distances_from(target)[other_target], b, options_.doubt);
}

void Growth::find_nearest_matched(int source, const std::vector<int>& map) {
  near_.clear();
  for (int j : nearest_[source]) {
    if (j == source || map[j] == kUnmatched) continue;
    near_.push_back(j);
    if (static_cast<int>(near_.size()) == options_.neighbours) return;
  }
}

/// How well the directions to the nearest matches agree after a rotation, less how well they agree
/// after a reflection.
float Growth::orientation(int source, int target, const std::vector<int>& map) const {
  std::complex<float> rotation = 0, reflection = 0;
  for (int j : near_) {
    const auto a = source_.direction(source, j);
    const auto b = target_.direction(target, map[j]);
    rotation += std::conj(a) * b;
    reflection += a * b;
  }
  const auto count = static_cast<float>(std::max<std::size_t>(1, near_.size()));
  // Not `std::abs`, whose care for overflow takes most of the time of all this.
  return (std::sqrt(std::norm(rotation)) - std::sqrt(std::norm(reflection))) / count;
}

int Growth::best_target(int source, const std::vector<int>& map) {
  accumulate(source, map);
  const auto least = std::ranges::min_element(cost_);
  if (*least > options_.price) return kUnmatched;
  if (!oriented_) return static_cast<int>(least - cost_.begin());
  find_nearest_matched(source, map);
  const float limit = *least + options_.slack;
  int best = static_cast<int>(least - cost_.begin());
  float best_score = std::numeric_limits<float>::max();
  for (int t = 0; t < target_count_; ++t) {
    if (cost_[t] > limit) continue;
    const float score =
        cost_[t] + options_.orientation_weight * (1 - orientation(source, t, map)) / 2;
    if (score < best_score) {
      best_score = score;
      best = t;
    }
  }
  return best;
}

LandmarkMap Growth::only(const Correspondence& matches) const {
  LandmarkMap map{std::vector<int>(source_count_, kUnmatched)};
  for (const Match& match : matches) map.target_of_source[match.source] = match.target;
  return map;
}

LandmarkMap Growth::grow(const Correspondence& matches) {
  LandmarkMap map = only(matches);
  for (int i = 0; i < source_count_; ++i) {
    int& target = map.target_of_source[i];
    if (target == kUnmatched) target = best_target(i, map.target_of_source);
  }
  return map;
}

void Growth::revise(LandmarkMap& map) {
  for (int i = options_.fixed; i < source_count_; ++i)
    map.target_of_source[i] = best_target(i, map.target_of_source);
}

void Growth::measure(LandmarkMap& map) {
  map.distortion = map.orientation = 0;
  const std::vector<int>& targets = map.target_of_source;
  const auto matched = static_cast<float>(source_count_ - std::ranges::count(targets, kUnmatched));
  const auto n = static_cast<float>(source_count_);
  for (int i = 0; i < source_count_; ++i) {
    if (targets[i] == kUnmatched) {
      map.distortion += options_.price / n;
      continue;
    }
    float sum = 0;
    for (int j = 0; j < source_count_; ++j)
      if (targets[j] != kUnmatched) sum += difference(i, j, targets[i], targets[j]);
    map.distortion += sum / (n * matched);
    find_nearest_matched(i, targets);
    map.orientation += orientation(i, targets[i], targets) / matched;
  }
}

}  // namespace isomatch::tracked
