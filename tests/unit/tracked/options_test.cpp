// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

#include "isomatch/error.h"
#include "tracked/option_list.h"

namespace isomatch::tracked {
namespace {

using testing::HasSubstr;

/// What `validate` says after the number of this name became `value`; empty if nothing.
std::string complaint(const std::string& name, double value) {
  Options options;
  int found = 0;
  for_each_number(options, [&](const std::string& known, auto& number) {
    if (known != name) return;
    number = static_cast<std::remove_reference_t<decltype(number)>>(value);
    ++found;
  });
  EXPECT_EQ(found, 1) << name;
  try {
    options.validate();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

TEST(Options, AreListedOnceEach) {
  Options options;
  std::set<std::string> names;
  for_each_number(options, [&](const std::string& name, auto&) {
    EXPECT_TRUE(names.insert(name).second) << name;
  });
  EXPECT_GT(names.size(), 100);
}

TEST(Options, DefaultsAreInRange) { EXPECT_NO_THROW(Options().validate()); }

TEST(Options, OutOfRangeAreNamed) {
  EXPECT_THAT(complaint("pyramid.functions", 0), HasSubstr("pyramid.functions"));
  EXPECT_THAT(complaint("judging.first_length", -1), HasSubstr("judging.first_length"));
  EXPECT_THAT(complaint("mending.tolerable", std::numeric_limits<double>::quiet_NaN()),
              HasSubstr("mending.tolerable"));
  EXPECT_THAT(complaint("pyramid.middle_nodes", 5000), HasSubstr("more nodes than the fine"));
  EXPECT_THAT(complaint("pyramid.middle_nodes", 800), HasSubstr("more nodes than distances"));
  EXPECT_THAT(complaint("pyramid.proxy.measured_nodes", 250), HasSubstr("than distances"));
}

TEST(Options, ThatMayBeNothingMayBeZero) {
  for (const char* name : {"rounds", "settling.surface_steps", "fine_projection.relief"})
    EXPECT_EQ(complaint(name, 0), "") << name;
}

}  // namespace
}  // namespace isomatch::tracked
