// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/merging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

#include "isomatch/error.h"
#include "support/context.h"
#include "support/metric_surface.h"
#include "support/random.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

/// One shape sampled on two levels and the fields of its landmarks.
struct SampledShape {
  explicit SampledShape(const Mesh& mesh)
      : shape(test::metric_surface(mesh)), coarser(sampled(0.35, {})), fields(shape) {
    level.sampling = sampled(0.12, coarser.bases);
    level.neighbourhoods = {shape, level.sampling.bases, 2 * coarser.radius};
  }

  BaseSampling sampled(double share, const std::vector<int>& inherited) const {
    return sample_bases(shape, test::Random(1).permutation(shape.num_vertices()), inherited,
                        static_cast<float>(share * shape.max_geodesic()));
  }

  MetricSurface shape;
  BaseSampling coarser;
  ShapeLevel level;
  FieldStore fields;
};

/// Two shapes on one level, all coarser source bases as landmarks.
class Merging : public testing::Test {
 protected:
  /// Random partners, at least one for every base of both shapes.
  Correspondence random_proposals(int each, std::uint64_t seed) const {
    test::Random random(seed);
    Correspondence proposals;
    for (int s = 0; s < num_source(); ++s) {
      for (int i = 0; i < each; ++i) proposals.push_back({s, random.index(num_target())});
    }
    for (int t = 0; t < num_target(); ++t) proposals.push_back({random.index(num_source()), t});
    std::sort(proposals.begin(), proposals.end());
    proposals.erase(std::unique(proposals.begin(), proposals.end()), proposals.end());
    return proposals;
  }

  std::vector<int> random_inherited(std::uint64_t seed) const {
    test::Random random(seed);
    std::vector<int> inherited(level_.landmarks.size());
    for (int& target : inherited) target = random.index(num_target());
    return inherited;
  }

  MergeResult merge(const Correspondence& proposals, const std::vector<int>& inherited,
                    const MergingOptions& options, const Context& context = {}) {
    return merge_matches(level_, proposals, inherited, source_.fields, target_.fields, options,
                         context);
  }

  MatchDistortion distortion(const std::vector<int>& list) {
    return landmark_distortion(level_, list, source_.fields, target_.fields);
  }

  int num_source() const { return level_.source.num_bases(); }
  int num_target() const { return level_.target.num_bases(); }

  SampledShape source_{test::rough_sphere(3, 0.3, 1)}, target_{test::rough_sphere(3, 0.3, 2)};
  SampledLevel level_{source_.level, target_.level, all_coarser_bases()};

 private:
  std::vector<int> all_coarser_bases() const {
    std::vector<int> landmarks(source_.coarser.bases.size());
    std::iota(landmarks.begin(), landmarks.end(), 0);
    return landmarks;
  }
};

/// The paper's text: no candidates but the proposed ones, every step once.
constexpr MergingOptions kText{.candidate_radius = 0, .relaxation_rounds = 1, .outlier_rounds = 1};
/// Steps 1 and 2 only.
constexpr MergingOptions kNoOutliers{
    .candidate_radius = 0, .relaxation_rounds = 1, .outlier_rounds = 0};

void expect_covering(const BaseMatching& merged, int num_source, int num_target) {
  ASSERT_EQ(merged.target_of_source.size(), num_source);
  ASSERT_EQ(merged.source_of_isolated.size(), num_target);
  const std::set<int> image(merged.target_of_source.begin(), merged.target_of_source.end());
  EXPECT_GE(*image.begin(), 0);
  EXPECT_LT(*image.rbegin(), num_target);
  for (int t = 0; t < num_target; ++t) {
    const int source = merged.source_of_isolated[t];
    EXPECT_EQ(source == kUnmatched, image.contains(t));
    EXPECT_LT(source, num_source);
  }
}

TEST_F(Merging, CoversEveryBaseOfBothShapesWhateverIsProposed) {
  for (const MergingOptions& options : {MergingOptions{}, kText, kNoOutliers}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      const MergeResult result = merge(random_proposals(3, seed), random_inherited(seed), options);
      expect_covering(result.merged, num_source(), num_target());
      EXPECT_EQ(result.many_to_one.size(), num_source());
      EXPECT_GE(std::ranges::min(result.many_to_one), 0);
      EXPECT_LT(std::ranges::max(result.many_to_one), num_target());
    }
  }
}

TEST_F(Merging, StepOneKeepsTheLeastDistortedProposal) {
  const Correspondence proposals = random_proposals(4, 4);
  const std::vector<int> inherited = random_inherited(4);
  const MatchDistortion d = distortion(inherited);
  std::vector<int> expected(num_source(), kUnmatched);
  for (const auto& [s, t] : proposals) {
    if (expected[s] == kUnmatched || d(s, t) < d(s, expected[s])) expected[s] = t;
  }
  EXPECT_EQ(merge(proposals, inherited, kText).many_to_one, expected);
  EXPECT_EQ(merge(proposals, inherited, kNoOutliers).merged.target_of_source, expected);
}

TEST_F(Merging, StepOneLooksAroundTheProposalsAsFarAsItIsTold) {
  const Correspondence proposals = random_proposals(2, 5);
  const std::vector<int> inherited = random_inherited(5);
  const MatchDistortion d = distortion(inherited);
  const MergingOptions options{.candidate_radius = 1.5, .relaxation_rounds = 1};
  std::vector<int> expected(num_source(), kUnmatched);
  std::vector<double> least(num_source(), std::numeric_limits<double>::infinity());
  const float reach = 1.5f * level_.target.sampling.radius;
  for (int t = 0; t < num_target(); ++t) {
    for (const Match& proposal : proposals) {
      const int s = proposal.source;
      if (level_.target.neighbourhoods.distance(proposal.target, t) > reach) continue;
      if (d(s, t) < least[s]) {
        least[s] = d(s, t);
        expected[s] = t;
      }
    }
  }
  EXPECT_EQ(merge(proposals, inherited, options).many_to_one, expected);
}

TEST_F(Merging, StepTwoGivesIsolatedTargetsTheLeastDistortedSourceProposed) {
  const Correspondence proposals = random_proposals(4, 6);
  const std::vector<int> inherited = random_inherited(6);
  const MergeResult result = merge(proposals, inherited, kNoOutliers);
  const MatchDistortion d = distortion(inherited);
  int isolated = 0;
  for (int t = 0; t < num_target(); ++t) {
    const int found = result.merged.source_of_isolated[t];
    if (found == kUnmatched) continue;
    ++isolated;
    double least = std::numeric_limits<double>::infinity();
    for (const Match& match : proposals) {
      if (match.target == t) least = std::min(least, d(match.source, t));
    }
    EXPECT_EQ(d(found, t), least);
    EXPECT_TRUE(std::ranges::binary_search(proposals, Match{found, t}));
  }
  EXPECT_GT(isolated, 0);
}

TEST_F(Merging, ReportsTheDistortionAgainstItsOwnList) {
  for (const MergingOptions& options : {MergingOptions{}, kText, kNoOutliers}) {
    const MergeResult result = merge(random_proposals(3, 7), random_inherited(7), options);
    const MatchDistortion d = distortion(result.merged.target_of_source);
    EXPECT_EQ(result.distortion, d.of(result.merged.matches()));
    EXPECT_EQ(result.many_to_one_distortion, d.of(to_correspondence(result.many_to_one)));
  }
}

TEST_F(Merging, MovingOutliersLowersTheDistortion) {
  const Correspondence proposals = random_proposals(3, 8);
  const std::vector<int> inherited = random_inherited(8);
  EXPECT_EQ(merge(proposals, inherited, kNoOutliers).outliers_moved, 0);
  const MergeResult kept = merge(proposals, inherited, kNoOutliers);
  const MergeResult moved = merge(proposals, inherited, {.outlier_factor = 1});
  EXPECT_GT(moved.outliers_moved, 0);
  EXPECT_LT(summarize(moved.distortion).mean, summarize(kept.distortion).mean);
}

TEST_F(Merging, AtLevelZeroTheFirstProposalsMakeTheList) {
  const Correspondence proposals = random_proposals(1, 9);
  std::vector<int> first(num_source(), kUnmatched);
  for (const auto& [s, t] : proposals) {
    if (first[s] == kUnmatched) first[s] = t;
  }
  EXPECT_EQ(merge(proposals, {}, kText).many_to_one, merge(proposals, first, kText).many_to_one);
}

TEST_F(Merging, ThreadsChangeNothing) {
  const Correspondence proposals = random_proposals(5, 10);
  const std::vector<int> inherited = random_inherited(10);
  const MergeResult one = merge(proposals, inherited, {}, test::with_threads(1));
  const MergeResult three = merge(proposals, inherited, {}, test::with_threads(3));
  EXPECT_EQ(one.many_to_one, three.many_to_one);
  EXPECT_EQ(one.merged.matches(), three.merged.matches());
  EXPECT_EQ(one.outliers_moved, three.outliers_moved);
  EXPECT_EQ(one.distortion, three.distortion);
}

/// A shape and itself.
class MergingOfEqualShapes : public Merging {
 protected:
  MergingOfEqualShapes() {
    target_.fields = FieldStore(source_.shape);
    level_.target = level_.source;
  }

  std::vector<int> identity() const {
    std::vector<int> bases(num_source());
    std::iota(bases.begin(), bases.end(), 0);
    return bases;
  }

  /// The identity but for `swaps` pairs of bases, which are matched crosswise.
  std::vector<int> with_swaps(int swaps, std::uint64_t seed) const {
    std::vector<int> targets = identity();
    const std::vector<int> bases = test::Random(seed).permutation(num_source());
    for (int i = 0; i < swaps; ++i) std::swap(targets[bases[2 * i]], targets[bases[2 * i + 1]]);
    return targets;
  }
};

TEST_F(MergingOfEqualShapes, KeepTheIdentity) {
  for (const MergingOptions& options : {MergingOptions{}, kText}) {
    const MergeResult result = merge(to_correspondence(identity()), identity(), options);
    EXPECT_EQ(result.many_to_one, identity());
    EXPECT_EQ(result.merged.matches(), to_correspondence(identity()));
    EXPECT_EQ(result.outliers_moved, 0);
    EXPECT_EQ(summarize(result.distortion).max, 0);
  }
}

TEST_F(MergingOfEqualShapes, PlantedOutliersAreMovedToTheirPlaces) {
  MergingOptions options = kText;
  options.outlier_rounds = 4;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    // Landmarks are among the bases that are swapped.
    const std::vector<int> swapped = with_swaps(num_source() / 20, seed);
    const MergeResult result = merge(to_correspondence(swapped), identity(), options);
    EXPECT_EQ(result.many_to_one, swapped);
    EXPECT_EQ(result.merged.matches(), to_correspondence(identity()));
    EXPECT_GE(result.outliers_moved, 2 * (num_source() / 20));
    EXPECT_EQ(summarize(result.distortion).max, 0);
    EXPECT_GT(summarize(result.many_to_one_distortion).max, 0);
  }
}

TEST_F(MergingOfEqualShapes, NeighboursOfProposalsStandInForThem) {
  // Each base is proposed its nearest neighbours only; the base itself is within two radii.
  std::set<Match> proposals;
  for (int s = 0; s < num_source(); ++s) {
    Match nearest{s, kUnmatched};
    for (const auto& neighbour : level_.source.neighbourhoods[s]) {
      if (neighbour.base != s &&
          (nearest.target == kUnmatched ||
           neighbour.distance < level_.source.neighbourhoods.distance(s, nearest.target)))
        nearest.target = neighbour.base;
    }
    proposals.insert(nearest);
    proposals.insert({nearest.target, s});
  }
  const Correspondence sorted(proposals.begin(), proposals.end());
  EXPECT_NE(merge(sorted, identity(), kNoOutliers).many_to_one, identity());
  EXPECT_EQ(merge(sorted, identity(), {}).many_to_one, identity());
}

TEST(BaseMatching, ListsTheMatchesOfBothDirectionsInOrder) {
  const BaseMatching matching{{2, 0, 2}, {kUnmatched, 0, kUnmatched, 1}};
  EXPECT_EQ(matching.matches(), (Correspondence{{0, 1}, {0, 2}, {1, 0}, {1, 3}, {2, 2}}));
  EXPECT_TRUE(BaseMatching{}.matches().empty());
}

TEST_F(Merging, RejectsOptionsOutOfRange) {
  const Correspondence proposals = random_proposals(1, 11);
  const auto rejects = [&](const MergingOptions& options) {
    EXPECT_THROW(merge(proposals, {}, options), InvalidInput);
  };
  rejects({.outlier_factor = -1});
  rejects({.outlier_factor = std::numeric_limits<double>::quiet_NaN()});
  rejects({.candidate_radius = -0.1});
  rejects({.candidate_radius = 2.1});
  rejects({.relaxation_rounds = 0});
  rejects({.outlier_rounds = -1});
}

}  // namespace
}  // namespace isomatch
