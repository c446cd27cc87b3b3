// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "shape/memo.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace isomatch {
namespace {

TEST(Memo, MakesAValueOnceForEachKey) {
  Memo<int, int> memo;
  int made = 0;
  const auto square_of = [&](int key) {
    return memo.get(key, [&] {
      ++made;
      return key * key;
    });
  };
  const auto first = square_of(3);
  EXPECT_EQ(*first, 9);
  EXPECT_EQ(square_of(3), first);
  EXPECT_EQ(*square_of(-4), 16);
  EXPECT_EQ(square_of(3), first);
  EXPECT_EQ(made, 2);
}

TEST(Memo, TriesAgainWhatThrew) {
  Memo<bool, int> memo;
  EXPECT_THROW(memo.get(true, []() -> int { throw std::runtime_error("not yet"); }),
               std::runtime_error);
  EXPECT_EQ(*memo.get(true, [] { return 5; }), 5);
  EXPECT_EQ(*memo.get(true, [] { return 6; }), 5);
}

TEST(Memo, OneThreadMakesWhatAllWaitFor) {
  Memo<int, int> memo;
  std::atomic<int> made = 0;
  constexpr int kThreads = 8, kKeys = 20;
  std::vector<std::vector<const int*>> seen(kThreads);
  {
    std::vector<std::jthread> threads;
    for (std::vector<const int*>& own : seen)
      threads.emplace_back([&] {
        for (int key = 0; key < kKeys; ++key)
          own.push_back(memo.get(key,
                                 [&] {
                                   ++made;
                                   std::this_thread::yield();
                                   return key;
                                 })
                            .get());
      });
  }
  EXPECT_EQ(made, kKeys);
  for (const auto& own : seen) EXPECT_EQ(own, seen.front());
  for (int key = 0; key < kKeys; ++key) EXPECT_EQ(*seen.front()[key], key);
}

}  // namespace
}  // namespace isomatch
