// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "isomatch/error.h"
#include "method.h"
#include "pairs.h"

namespace isomatch::baselines {
namespace {

TEST(Methods, AreFoundByName) {
  std::vector<std::string> names;
  for (const Method& method : methods()) names.push_back(find_method(method.name).name);
  EXPECT_THAT(names, testing::ElementsAre("paper", "paper-oriented", "tracked", "spectral", "gmds",
                                          "zoomout"));
}

TEST(Methods, UnknownNameIsAnsweredWithAllNames) {
  try {
    find_method("magic");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(
        error.what(),
        "there is no method 'magic': paper, paper-oriented, tracked, spectral, gmds, zoomout");
  }
}

TEST(Methods, EveryFinalMapIsRightOnARelabelledShape) {
  const test::KnownPair pair = test::relabelled_pair(1000);
  for (const Method& method : methods()) {
    const MethodResult result = method.run(pair.source, pair.target, {});
    ASSERT_EQ(result.maps.front().name, kFinalMap);
    const Correspondence& matches = result.maps.front().matches;
    EXPECT_TRUE(std::ranges::is_sorted(matches)) << method.name;
    std::set<int> sources;
    for (const Match& match : matches) EXPECT_TRUE(sources.insert(match.source).second);
    EXPECT_LT(pair.error(matches), 0.03) << method.name;
  }
}

}  // namespace
}  // namespace isomatch::baselines
