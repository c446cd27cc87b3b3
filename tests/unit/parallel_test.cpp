// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "isomatch/error.h"
#include "support/context.h"

namespace isomatch {
namespace {

using test::with_threads;

TEST(ParallelFor, VisitsEveryIndexOnce) {
  for (const int threads : {1, 2, 5}) {
    for (const int count : {0, 1, 7, 100'000}) {
      std::vector<int> visits(count, 0);
      parallel_for(count, with_threads(threads), [&](std::ptrdiff_t i) { ++visits[i]; });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << threads;
    }
  }
}

TEST(ParallelFor, ExceptionsDoNotEndTheProgramButReachTheCaller) {
  for (const int threads : {1, 2, 5}) {
    const auto work = [&] {
      parallel_for(10'000, with_threads(threads), [](std::ptrdiff_t i) {
        if (i % 1000 == 999) throw std::runtime_error(std::to_string(i));
      });
    };
    try {
      work();
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "999") << threads;
    }
  }
}

TEST(ParallelFor, AThreadWithoutMemoryForItsStateDoesNotEndTheProgram) {
  std::atomic<int> states = 0;
  const auto make = [&]() -> int {
    if (states++ == 0) throw std::bad_alloc();
    return 0;
  };
  EXPECT_THROW(parallel_for(100, with_threads(3), make, [](int&, std::ptrdiff_t) {}),
               std::bad_alloc);
}

TEST(ParallelFor, AStopLeavesOutTheRest) {
  std::stop_source stop;
  Context context = with_threads(2);
  context.stop = stop.get_token();
  std::atomic<int> visits = 0;
  EXPECT_THROW(parallel_for(1'000'000, context,
                            [&](std::ptrdiff_t) {
                              ++visits;
                              stop.request_stop();
                            }),
               Cancelled);
  EXPECT_LT(visits, 10'000);
}

}  // namespace
}  // namespace isomatch
