// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/merging.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "isomatch/error.h"
#include "parallel.h"

namespace isomatch {
namespace {

/// Target bases among which step 3 looks for a start; the first ones, so those of coarser levels.
constexpr int kMaxDescentStarts = 500;

struct Choice {
  double distortion = std::numeric_limits<double>::infinity();
  int base = kUnmatched;

  void offer(double candidate_distortion, int candidate) {
    if (candidate_distortion < distortion) *this = {candidate_distortion, candidate};
  }
};

void sort_unique(std::vector<int>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

class Merger {
 public:
  Merger(const SampledLevel& level, const Correspondence& proposals, FieldStore& source_fields,
         FieldStore& target_fields, const MergingOptions& options, const Context& context)
      : level_(level),
        source_fields_(source_fields),
        target_fields_(target_fields),
        options_(options),
        context_(context),
        num_source_(level.source.num_bases()),
        num_target_(level.target.num_bases()),
        proposed_targets_(num_source_),
        proposed_sources_(num_target_) {
    for (const Match& match : proposals) {
      proposed_targets_[match.source].push_back(match.target);
      proposed_sources_[match.target].push_back(match.source);
    }
  }

  MergeResult run(std::span<const int> inherited) {
    if (inherited.empty()) {
      set_list(first_proposals());
    } else {
      set_list(inherited);
    }
    MergeResult result;
    choose_targets(proposed_targets_);
    for (int round = 1; round < options_.relaxation_rounds; ++round) {
      set_list(matching_.target_of_source);
      choose_targets(matched_targets());
    }
    result.many_to_one = matching_.target_of_source;
    matching_.source_of_isolated.assign(num_target_, kUnmatched);
    repair_isolated_targets();
    set_list(matching_.target_of_source);
    for (int round = 0; round < options_.outlier_rounds; ++round) {
      const int moved = move_outliers();
      result.outliers_moved += moved;
      repair_isolated_targets();
      if (moved == 0) break;
      set_list(matching_.target_of_source);
    }
    result.many_to_one_distortion = distortion_.of(to_correspondence(result.many_to_one));
    result.distortion = distortion_.of(matching_.matches());
    result.merged = std::move(matching_);
    return result;
  }

 private:
  void set_list(std::span<const int> target_of_source) {
    distortion_ =
        landmark_distortion(level_, target_of_source, source_fields_, target_fields_, context_);
  }

  std::vector<int> first_proposals() const {
    std::vector<int> targets;
    for (const auto& proposed : proposed_targets_) targets.push_back(proposed.front());
    return targets;
  }

  std::vector<std::vector<int>> matched_targets() const {
    std::vector<std::vector<int>> targets;
    for (int target : matching_.target_of_source) targets.push_back({target});
    return targets;
  }

  /// `centres` and all bases within the candidate radius of one, in ascending order.
  std::vector<int> widened(const std::vector<int>& centres, const ShapeLevel& shape) const {
    const double radius = options_.candidate_radius * shape.sampling.radius;
    std::vector<int> result = centres;
    for (int centre : centres) {
      for (const auto& neighbour : shape.neighbourhoods[centre]) {
        if (neighbour.distance <= radius) result.push_back(neighbour.base);
      }
    }
    sort_unique(result);
    return result;
  }

  /// Step 1 around `centres`, which has the targets to start from for every source base.
  void choose_targets(const std::vector<std::vector<int>>& centres) {
    matching_.target_of_source.assign(num_source_, kUnmatched);
    parallel_for(num_source_, context_, [&](std::ptrdiff_t i) {
      const int s = static_cast<int>(i);
      Choice best;
      for (int t : widened(centres[s], level_.target)) best.offer(distortion_(s, t), t);
      matching_.target_of_source[s] = best.base;
    });
  }

  std::vector<std::vector<int>> sources_of_targets() const {
    std::vector<std::vector<int>> sources(num_target_);
    for (int s = 0; s < num_source_; ++s) sources[matching_.target_of_source[s]].push_back(s);
    return sources;
  }

  /// Step 2: a source for every target base outside the image, none for those inside.
  void repair_isolated_targets() {
    const std::vector<std::vector<int>> sources = sources_of_targets();
    parallel_for(num_target_, context_, [&](std::ptrdiff_t i) {
      const int t = static_cast<int>(i);
      int& assigned = matching_.source_of_isolated[t];
      if (!sources[t].empty()) {
        assigned = kUnmatched;
      } else if (assigned == kUnmatched) {
        assigned = best_source(t, sources);
      }
    });
  }

  int best_source(int target, const std::vector<std::vector<int>>& sources) const {
    std::vector<int> candidates = proposed_sources_[target];
    for (int t : widened({target}, level_.target))
      candidates.insert(candidates.end(), sources[t].begin(), sources[t].end());
    sort_unique(candidates);
    Choice best;
    for (int s : candidates) best.offer(distortion_(s, target), s);
    return best.base;
  }

  /// Step 3: moves what exceeds the multiple of the mean; returns how many matches changed.
  int move_outliers() {
    const double limit =
        options_.outlier_factor * summarize(distortion_.of(matching_.matches())).mean;
    std::atomic<int> moved = 0;
    parallel_for(num_source_, context_, [&](std::ptrdiff_t i) {
      const int s = static_cast<int>(i);
      int& target = matching_.target_of_source[s];
      moved += move_outlier(distortion_(s, target), limit, target, num_target_,
                            level_.target.neighbourhoods,
                            [&](int candidate) { return distortion_(s, candidate); });
    });
    parallel_for(num_target_, context_, [&](std::ptrdiff_t i) {
      const int t = static_cast<int>(i);
      int& source = matching_.source_of_isolated[t];
      if (source == kUnmatched) return;
      moved += move_outlier(distortion_(source, t), limit, source, num_source_,
                            level_.source.neighbourhoods,
                            [&](int candidate) { return distortion_(candidate, t); });
    });
    return moved;
  }

  template <class Distortion>
  static int move_outlier(double current, double limit, int& partner, int num_partners,
                          const BaseNeighbourhoods& neighbourhoods, const Distortion& distortion) {
    if (current <= limit) return 0;
    Choice best{current, partner};
    for (int start = 0; start < std::min(num_partners, kMaxDescentStarts); ++start)
      best.offer(distortion(start), start);
    for (int centre = kUnmatched; centre != best.base;) {
      centre = best.base;
      for (const auto& neighbour : neighbourhoods[centre])
        best.offer(distortion(neighbour.base), neighbour.base);
    }
    const bool moved = best.base != partner;
    partner = best.base;
    return moved;
  }

  const SampledLevel& level_;
  FieldStore& source_fields_;
  FieldStore& target_fields_;
  const MergingOptions& options_;
  const Context& context_;
  int num_source_, num_target_;
  std::vector<std::vector<int>> proposed_targets_, proposed_sources_;
  MatchDistortion distortion_;
  BaseMatching matching_;
};

}  // namespace

void MergingOptions::validate() const {
  if (!(outlier_factor >= 0)) throw InvalidInput("outlier_factor must not be negative");
  if (!(candidate_radius >= 0 && candidate_radius <= 2))
    throw InvalidInput("candidate_radius must be in [0, 2]");
  if (relaxation_rounds < 1) throw InvalidInput("relaxation_rounds must be at least 1");
  if (outlier_rounds < 0) throw InvalidInput("outlier_rounds must not be negative");
}

Correspondence BaseMatching::matches() const {
  Correspondence result = to_correspondence(target_of_source);
  for (int t = 0; t < static_cast<int>(source_of_isolated.size()); ++t) {
    if (source_of_isolated[t] != kUnmatched) result.push_back({source_of_isolated[t], t});
  }
  std::sort(result.begin(), result.end());
  return result;
}

MergeResult merge_matches(const SampledLevel& level, const Correspondence& proposals,
                          std::span<const int> inherited, FieldStore& source_fields,
                          FieldStore& target_fields, const MergingOptions& options,
                          const Context& context) {
  options.validate();
  return Merger(level, proposals, source_fields, target_fields, options, context).run(inherited);
}

}  // namespace isomatch
