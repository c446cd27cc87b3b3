// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/mending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "support/shapes.h"
#include "unit/tracked/prepared.h"

namespace isomatch::tracked {
namespace {

using test::Prepared;

constexpr int kNodes = 200;

/// Maps of the first nodes of a shape to itself.
class MendingTest : public testing::Test {
 protected:
  MendingTest() { std::iota(identity_.begin(), identity_.end(), 0); }

  static std::vector<int> mend(const Proxy& proxy, std::vector<int> map) {
    const NodeGraph graph = node_graph(proxy, kNodes);
    return mended(proxy, proxy, graph.cloud.areas, std::move(map), kNodes, {});
  }

  std::vector<int> around(int node, float radius) const {
    std::vector<int> nodes;
    for (int i = 0; i < kNodes; ++i)
      if (creature_.node_distance(node, i) < radius) nodes.push_back(i);
    return nodes;
  }

  const Proxy creature_ = Prepared(synthesize({.vertices = 2000, .pose = 3}).mesh).proxy;
  std::vector<int> identity_ = std::vector<int>(kNodes);
};

TEST_F(MendingTest, LeavesTheIdentityAlone) {
  EXPECT_EQ(mend(creature_, identity_), identity_);
  EXPECT_EQ(mend(Prepared(test::icosphere(4)).proxy, identity_), identity_);
}

TEST_F(MendingTest, PutsASingleNodeBack) {
  // Node 0 and 1 are far apart.
  for (const auto& [node, wrong] : {std::pair(7, 0), std::pair(50, 1), std::pair(150, 0)}) {
    std::vector<int> map = identity_;
    map[node] = wrong;
    ASSERT_GT(creature_.node_distance(node, wrong), 0.1);
    EXPECT_EQ(mend(creature_, map), identity_);
  }
}

TEST_F(MendingTest, PutsExchangedPartsBack) {
  std::vector<int> map = identity_;
  const std::vector<int> part = around(0, 0.15F);
  const std::vector<int> other = around(1, 0.15F);
  ASSERT_GE(part.size(), 3);
  ASSERT_GE(other.size(), 3);
  ASSERT_GT(creature_.node_distance(0, 1), 0.4);
  for (int i : part) map[i] = 1;
  for (int i : other) map[i] = 0;
  const std::vector<int> result = mend(creature_, map);
  for (int i = 0; i < kNodes; ++i) EXPECT_LT(creature_.node_distance(result[i], i), 0.1) << i;
}

TEST_F(MendingTest, LeavesNodesThatAreSlightlyOff) {
  std::vector<int> map = identity_;
  const std::vector<int> near = around(20, 0.1F);
  ASSERT_GE(near.size(), 2);
  map[20] = near[0] == 20 ? near[1] : near[0];
  EXPECT_EQ(mend(creature_, map), map);
}

TEST_F(MendingTest, BelievesTheGreaterArea) {
  // A part of many nodes and little area does not pull the rest along.
  std::vector<int> map = identity_;
  for (int i = 0; i < kNodes / 2; ++i) map[i] = 0;
  std::vector<double> areas(kNodes, 1);
  std::fill_n(areas.begin(), kNodes / 2, 1e-6);
  const std::vector<int> result = mended(creature_, creature_, areas, map, kNodes, {});
  for (int i = 0; i < kNodes; ++i) EXPECT_LT(creature_.node_distance(result[i], i), 0.1) << i;
}

}  // namespace
}  // namespace isomatch::tracked
