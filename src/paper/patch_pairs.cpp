// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/patch_pairs.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "parallel.h"

namespace isomatch::paper {
namespace {

/// Bases of `level` within `radius` of the base `centre`, those of coarser levels first.
std::vector<int> bases_in_patch(const ShapeLevel& level, int centre, float radius) {
  std::vector<int> bases;
  for (const auto& neighbour : level.neighbourhoods[centre]) {
    if (neighbour.distance <= radius) bases.push_back(neighbour.base);
  }
  return bases;
}

Eigen::MatrixXf distances_among(const NormalizedLevel& shape, const std::vector<int>& bases) {
  const Eigen::Index count = static_cast<Eigen::Index>(bases.size());
  Eigen::MatrixXf distances = Eigen::MatrixXf::Zero(count, count);
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = 0; b < a; ++b)
      distances(a, b) = distances(b, a) = shape.distance(bases[a], bases[b]);
  }
  return distances;
}

/// Matches by index into `source_bases` and `target_bases` become matches by base.
Correspondence by_base(Correspondence matches, const std::vector<int>& source_bases,
                       const std::vector<int>& target_bases) {
  for (Match& match : matches) match = {source_bases[match.source], target_bases[match.target]};
  return matches;
}

class PatchPairMatcher {
 public:
  PatchPairMatcher(const SampledLevel& coarser, const MatchedLevel& previous,
                   const NormalizedLevel& source, const NormalizedLevel& target,
                   const MatchDistortion& distortion, const PatchMatchingOptions& options)
      : coarser_(coarser),
        previous_(previous),
        source_(source),
        target_(target),
        distortion_(distortion),
        options_(options) {}

  PatchMatching run(const Match& centres) const {
    const std::vector<int> source_bases =
        bases_in_patch(source_.level, centres.source, coarser_.source.sampling.radius);
    const std::vector<int> target_bases =
        bases_in_patch(target_.level, centres.target, coarser_.target.sampling.radius);
    const PatchProblem problem{
        distances_among(source_, source_bases), distances_among(target_, target_bases),
        list_distortion(source_bases, target_bases, parents_matches(centres))};
    return {centres, by_base(match_patch(problem, options_), source_bases, target_bases)};
  }

 private:
  /// The union of the matchings of all parent patch pairs.
  Correspondence parents_matches(const Match& centres) const {
    Correspondence list;
    for (const auto& neighbour : coarser_.source.neighbourhoods[centres.source]) {
      for (const PatchMatching& parent : patches_around(neighbour.base)) {
        if (contains(parent, centres))
          list.insert(list.end(), parent.matches.begin(), parent.matches.end());
      }
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  std::span<const PatchMatching> patches_around(int source_centre) const {
    const auto range =
        std::ranges::equal_range(previous_.patches, source_centre, {},
                                 [](const PatchMatching& patch) { return patch.centres.source; });
    return {range.begin(), range.end()};
  }

  /// Whether both `centres` lie in the patches of `parent`; those are the ones it matched.
  static bool contains(const PatchMatching& parent, const Match& centres) {
    const auto is_source = [&](const Match& match) { return match.source == centres.source; };
    const auto is_target = [&](const Match& match) { return match.target == centres.target; };
    return std::ranges::any_of(parent.matches, is_source) &&
           std::ranges::any_of(parent.matches, is_target);
  }

  Eigen::MatrixXf list_distortion(const std::vector<int>& source_bases,
                                  const std::vector<int>& target_bases,
                                  const Correspondence& parents) const {
    Eigen::MatrixXf sums(source_bases.size(), target_bases.size());
    for (Eigen::Index row = 0; row < sums.rows(); ++row) {
      for (Eigen::Index column = 0; column < sums.cols(); ++column)
        sums(row, column) = list_distortion(source_bases[row], target_bases[column], parents);
    }
    return sums;
  }

  float list_distortion(int source_base, int target_base, const Correspondence& parents) const {
    double sum = distortion_.list_size() * distortion_(source_base, target_base);
    for (const Match& match : parents)
      sum += std::abs(source_.distance(source_base, match.source) -
                      target_.distance(target_base, match.target));
    return static_cast<float>(sum);
  }

  const SampledLevel& coarser_;
  const MatchedLevel& previous_;
  const NormalizedLevel& source_;
  const NormalizedLevel& target_;
  const MatchDistortion& distortion_;
  const PatchMatchingOptions& options_;
};

}  // namespace

std::vector<Correspondence> match_whole_surfaces(const NormalizedLevel& source,
                                                 const NormalizedLevel& target, int count,
                                                 const PatchMatchingOptions& options) {
  std::vector<int> source_bases(source.level.num_bases()), target_bases(target.level.num_bases());
  std::iota(source_bases.begin(), source_bases.end(), 0);
  std::iota(target_bases.begin(), target_bases.end(), 0);
  const PatchProblem problem{distances_among(source, source_bases),
                             distances_among(target, target_bases),
                             Eigen::MatrixXf::Zero(source_bases.size(), target_bases.size())};
  PatchMatchingOptions whole = options;
  whole.max_patch_bases = std::max(options.max_patch_bases,
                                   std::max(source.level.num_bases(), target.level.num_bases()));
  return match_patch(problem, count, whole);
}

std::vector<PatchMatching> match_patch_pairs(
    const SampledLevel& coarser, const MatchedLevel& previous, const NormalizedLevel& source,
    const NormalizedLevel& target, const MatchDistortion& distortion,
    const PatchMatchingOptions& options, const Context& context) {
  const PatchPairMatcher matcher(coarser, previous, source, target, distortion, options);
  const Correspondence centres = previous.merge.merged.matches();
  std::vector<PatchMatching> patches(centres.size());
  parallel_for(std::ssize(patches), context,
               [&](std::ptrdiff_t m) { patches[m] = matcher.run(centres[m]); });
  return patches;
}

}  // namespace isomatch::paper
