// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/shapes.h"
#include "support/transforms.h"
#include "unit/tracked/cut.h"
#include "unit/tracked/matched_pair.h"

namespace isomatch {
namespace {

/// How a map of parts does against the truth of the whole shapes.
struct Outcome {
  /// Of template points whose counterpart was cut away, the share that has no point; of the others
  /// the share that has one.
  double left_out = 0, kept = 0;
  /// Of those that are rightly matched, over sqrt(area) of the whole.
  double error = 0;
};

struct Truth {
  std::vector<int> from, onto;
};

// NOLINTNEXTLINE(readability-function-size): one count after the other.
Outcome outcome(const Shape& from, const Shape& onto, const Truth& truth, const SurfaceMap& map,
                double whole_area) {
  GroundTruth common;
  int gone = 0, left_out = 0, present = 0;
  for (std::size_t k = 0; k < truth.from.size(); ++k) {
    if (!from.on_surface(truth.from[k])) continue;
    const bool matched = map[truth.from[k]].face >= 0;
    if (!onto.on_surface(truth.onto[k])) {
      ++gone;
      left_out += matched ? 0 : 1;
      continue;
    }
    ++present;
    if (!matched) continue;
    common.source.push_back(truth.from[k]);
    common.target.push_back(truth.onto[k]);
  }
  Outcome result;
  result.left_out = left_out / std::max(1.0, static_cast<double>(gone));
  result.kept = static_cast<double>(common.source.size()) / std::max(1, present);
  result.error = point_errors(from, onto, common, map).mean * std::sqrt(onto.area() / whole_area);
  return result;
}

void expect_good(const Outcome& outcome) {
  EXPECT_GT(outcome.left_out, 0.8);
  EXPECT_GT(outcome.kept, 0.8);
  EXPECT_LT(outcome.error, 0.06);
}

/// A creature, and another pose of it of which the hind part, below a plane, is missing.
class CutCreature : public testing::Test {
 protected:
  static constexpr double kCutAway = 0.4;

  const test::TruePair pair_ = test::creatures(1500, 2);
  const Shape whole_{pair_.source}, part_{test::cut(pair_.target, 2, kCutAway)};
  const double area_ = surface_area(pair_.target);
  const Truth truth_{pair_.source_truth, pair_.target_truth};
  const Truth reversed_{pair_.target_truth, pair_.source_truth};
};

TEST_F(CutCreature, AsTargetLeavesOutWhatIsMissingAndMatchesTheRest) {
  const TrackedResult result = match_tracked(whole_, part_);
  test::expect_sound_parts(result, whole_, part_);
  const TrackedMap& map = result.maps.front();
  expect_good(outcome(whole_, part_, truth_, map.source_to_target, area_));
  const Outcome back = outcome(part_, whole_, reversed_, map.target_to_source, area_);
  EXPECT_GT(back.kept, 0.8);
  EXPECT_LT(back.error, 0.06);
}

TEST_F(CutCreature, AsSourceIsMatchedWholly) {
  const TrackedResult result = match_tracked(part_, whole_);
  test::expect_sound_parts(result, part_, whole_);
  const TrackedMap& map = result.maps.front();
  const Outcome forth = outcome(part_, whole_, reversed_, map.source_to_target, area_);
  EXPECT_GT(forth.kept, 0.8);
  EXPECT_LT(forth.error, 0.06);
  expect_good(outcome(whole_, part_, truth_, map.target_to_source, area_));
}

TEST_F(CutCreature, OfTheSamePoseIsMatchedClosely) {
  std::vector<int> all(pair_.source.vertices.size());
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
  const Shape part(test::cut(pair_.source, 2, kCutAway));
  const TrackedMap map = match_tracked(whole_, part).maps.front();
  const Outcome result =
      outcome(whole_, part, {all, all}, map.source_to_target, surface_area(pair_.source));
  EXPECT_GT(result.left_out, 0.9);
  EXPECT_GT(result.kept, 0.9);
  EXPECT_LT(result.error, 0.02);
}

TEST_F(CutCreature, WithLoosePartsIsMatchedAndFinite) {
  Mesh mesh = pair_.source;
  for (int k = 0; k < 3; ++k) {
    Mesh ball = test::scaled(test::icosphere(1), 0.1);
    for (Point& p : ball.vertices) p += Point(2 + k, 0, k);
    mesh = test::combined(ball, mesh);
  }
  const Shape loose(mesh);
  test::expect_sound_parts(match_tracked(loose, part_), loose, part_);
}

TEST(WholeShapes, WithAPinholeAreStillWhole) {
  const test::TruePair pair = test::creatures(1000, 3);
  Mesh pricked = pair.target;
  pricked.faces.erase(pricked.faces.begin());
  const Shape source(pair.source), target(pricked);
  test::expect_sound(match_tracked(source, target), source, target);
}

}  // namespace
}  // namespace isomatch
