// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/shares.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <set>
#include <string>
#include <vector>

namespace isomatch::results {
namespace {

std::string shape(int number) { return std::to_string(number); }

ListedPair pair(int source, int target) {
  return {shape(source), shape(target), shape(source) + "__" + shape(target)};
}

/// Every ordered pair of so many shapes.
std::vector<ListedPair> every_pair(int shapes) {
  std::vector<ListedPair> pairs;
  for (int i = 0; i < shapes; ++i)
    for (int j = 0; j < shapes; ++j)
      if (i != j) pairs.push_back(pair(i, j));
  return pairs;
}

std::size_t shapes_in(const std::vector<ListedPair>& pairs) {
  std::set<std::string> shapes;
  for (const ListedPair& pair : pairs) shapes.insert({pair.source, pair.target});
  return shapes.size();
}

/// How many shapes are read if only so many are kept.
int reads(const std::vector<ListedPair>& pairs, const std::vector<std::size_t>& order,
          std::size_t kept) {
  std::list<std::string> held;
  int reads = 0;
  for (const std::size_t place : order)
    for (const std::string& shape : {pairs[place].source, pairs[place].target}) {
      if (std::erase(held, shape) == 0) ++reads;
      held.push_front(shape);
      if (held.size() > kept) held.pop_back();
    }
  return reads;
}

std::vector<std::size_t> order_of_list(const std::vector<ListedPair>& pairs) {
  std::vector<std::size_t> order;
  for (std::size_t place = 0; place < pairs.size(); ++place) order.push_back(place);
  return order;
}

TEST(Shares, AreTogetherAllPairsOnceEachInTheOrderOfTheList) {
  const std::vector<ListedPair> pairs = every_pair(12);
  for (const int count : {1, 2, 3, 7, 16, 132, 200}) {
    std::multiset<std::string> together;
    for (int share = 1; share <= count; ++share) {
      const std::vector<ListedPair> some = share_of(pairs, share, count);
      EXPECT_GE(some.size(), pairs.size() / static_cast<std::size_t>(count));
      EXPECT_LE(some.size(), pairs.size() / static_cast<std::size_t>(count) + 1);
      auto rest = pairs.begin();
      for (const ListedPair& pair : some) {
        together.insert(pair.name);
        rest = std::find_if(rest, pairs.end(), [&](const auto& p) { return p.name == pair.name; });
        ASSERT_NE(rest, pairs.end()) << pair.name << " comes too early";
      }
    }
    EXPECT_EQ(together.size(), pairs.size());
    EXPECT_EQ(std::set(together.begin(), together.end()).size(), pairs.size());
  }
}

/// n pairs need sqrt(n) shapes at least, and a square block of n sources and targets 2 sqrt(n).
TEST(Shares, NeedFewShapes) {
  for (const int shapes : {30, 71, 100})
    for (const int count : {2, 3, 5, 8, 13, 16, 40}) {
      const std::vector<ListedPair> pairs = every_pair(shapes);
      for (int share = 1; share <= count; ++share) {
        const std::vector<ListedPair> some = share_of(pairs, share, count);
        EXPECT_LE(shapes_in(some), 2 * std::sqrt(some.size()) + 1)
            << share << " of " << count << ", " << shapes << " shapes";
      }
    }
}

TEST(Shares, OfAStarOrAChainAreRuns) {
  std::vector<ListedPair> star, chain;
  for (int i = 1; i <= 100; ++i) {
    star.push_back(pair(0, i));
    chain.push_back(pair(i - 1, i));
  }
  for (int share = 1; share <= 7; ++share)
    for (const auto* pairs : {&star, &chain}) {
      const std::vector<ListedPair> some = share_of(*pairs, share, 7);
      EXPECT_EQ(shapes_in(some), some.size() + 1);
    }
  EXPECT_EQ(order_of_work(chain), order_of_list(chain));
}

TEST(OrderOfWork, ReadsShapesSeldomWhenFewAreKept) {
  const std::vector<ListedPair> pairs = every_pair(60);
  const std::vector<std::size_t> order = order_of_work(pairs);
  EXPECT_EQ(std::set(order.begin(), order.end()).size(), pairs.size());
  for (const std::size_t kept : {4, 8, 16, 32}) {
    const int in_blocks = reads(pairs, order, kept);
    const int by_rows = reads(pairs, order_of_list(pairs), kept);
    EXPECT_LT(in_blocks, 3 * by_rows / static_cast<int>(kept)) << kept << " kept: " << in_blocks;
  }
  EXPECT_EQ(reads(pairs, order, 60), 60);
}

}  // namespace
}  // namespace isomatch::results
