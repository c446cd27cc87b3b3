// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// That what shapes keep from one match to the next changes nothing.

#include <gtest/gtest.h>

#include <stop_token>
#include <string_view>
#include <thread>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/measure/fit.h"
#include "isomatch/methods/paper.h"
#include "support/context.h"
#include "unit/tracked/matched_pair.h"

namespace isomatch {
namespace {

void expect_same(const TrackedResult& a, const TrackedResult& b) {
  ASSERT_EQ(a.maps.size(), b.maps.size());
  for (std::size_t k = 0; k < a.maps.size(); ++k) {
    EXPECT_EQ(a.maps[k].source_to_target, b.maps[k].source_to_target);
    EXPECT_EQ(a.maps[k].target_to_source, b.maps[k].target_to_source);
    EXPECT_EQ(a.maps[k].registered, b.maps[k].registered);
    EXPECT_EQ(a.maps[k].energy, b.maps[k].energy);
    EXPECT_EQ(a.maps[k].mirrored, b.maps[k].mirrored);
  }
  EXPECT_EQ(a.ambiguity, b.ambiguity);
}

/// The pair has been matched once; the result is that of shapes made for it.
using KeptShapes = test::CreaturePair;

TEST_F(KeptShapes, AreMatchedAsFreshOnes) {
  // Other stages in between, which keep things with the shapes as well.
  TrackedOptions options;
  options.allow_reflection = true;
  options.refinement = false;
  expect_same(match_tracked(source_, target_, options),
              match_tracked(Shape(pair_.source), Shape(pair_.target), options));
  PaperOptions few_levels;
  few_levels.max_levels = 2;
  match_paper(source_, target_, few_levels);
  judge_fit(source_, target_, map_.source_to_target);
  expect_same(match_tracked(source_, target_), plain_->result);
}

TEST_F(KeptShapes, AreMatchedAfterAStopAsFreshOnes) {
  std::stop_source stop;
  Context context;
  context.stop = stop.get_token();
  context.progress = [&](double fraction, std::string_view) {
    if (fraction > 0.1) stop.request_stop();
  };
  const Shape source(pair_.source), target(pair_.target);
  EXPECT_THROW(match_tracked(source, target, {}, context), Cancelled);
  expect_same(match_tracked(source, target), plain_->result);
}

TEST_F(KeptShapes, MayBeSharedByThreads) {
  const Shape source(pair_.source), target(pair_.target);
  const Context alone = test::with_threads(1);
  std::vector<TrackedResult> results(2);
  std::vector<FitMeasures> fits(2);
  std::vector<double> lengths(2);
  {
    std::vector<std::jthread> threads;
    for (TrackedResult& result : results)
      threads.emplace_back([&] { result = match_tracked(source, target, {}, alone); });
    for (FitMeasures& fit : fits)
      threads.emplace_back(
          [&] { fit = judge_fit(source, target, map_.source_to_target, {}, alone).measures; });
    for (double& length : lengths)
      threads.emplace_back([&] { length = source.max_geodesic(alone); });
  }
  for (const TrackedResult& result : results) expect_same(result, plain_->result);
  const FitMeasures expected = judge_fit(source_, target_, map_.source_to_target).measures;
  for (const FitMeasures& fit : fits) EXPECT_EQ(fit.stretch, expected.stretch);
  for (double length : lengths) EXPECT_EQ(length, source_.max_geodesic());
}

}  // namespace
}  // namespace isomatch
