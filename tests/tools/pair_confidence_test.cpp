// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/drawing/pair_confidence.h"

#include <gmock/gmock.h>

#include "support/shapes.h"

namespace isomatch::results {
namespace {

using testing::ElementsAre;
using testing::IsNan;

/// Two triangles, vertex 0 to 2 and 1 to 1; the rest is unmatched.
class Confidence : public testing::Test {
 protected:
  Confidence() {
    result_.source = result_.target = test::sheet(1, 1);
    map_.source_to_target = {2, 1, kUnmatched, kUnmatched};
    map_.points = corner_points(result_.target, map_.source_to_target);
    map_.source_confidence = {0.9F, 0.4F, 0, 0};
  }

  PairConfidence confidence() const { return pair_confidence(result_, map_, matched_).value(); }

  MatchResult result_;
  ResultMap map_;
  const std::vector<bool> matched_{false, true, true, true};
};

TEST_F(Confidence, OfTheSourceIsThatOfTheFolder) {
  EXPECT_THAT(confidence().source, ElementsAre(0.9F, 0.4F, IsNan(), IsNan()));
}

TEST_F(Confidence, OfTheTargetIsItsOwn) {
  map_.target_confidence = {0, 0.1F, 0.2F, 0.3F};
  EXPECT_THAT(confidence().target, ElementsAre(IsNan(), 0.1F, 0.2F, 0.3F));
}

TEST_F(Confidence, OfTheTargetIsNotZeroWhereOnlyTheSourceLeads) {
  map_.target_confidence = {0, 0.1F, 0, 0.3F};
  EXPECT_THAT(confidence().target, ElementsAre(IsNan(), 0.1F, 0.9F, 0.3F));
}

TEST_F(Confidence, OfTheTargetIsElseThatOfTheSourceVertexNearby) {
  result_.target.vertices[3] = {0.1, 1, 0};
  EXPECT_THAT(confidence().target, ElementsAre(IsNan(), 0.4F, 0.9F, 0.9F));
}

TEST_F(Confidence, IsNotThereIfNoMethodTells) {
  map_.source_confidence.clear();
  EXPECT_FALSE(pair_confidence(result_, map_, matched_));
}

}  // namespace
}  // namespace isomatch::results
