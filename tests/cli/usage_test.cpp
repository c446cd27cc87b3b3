// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.h"

namespace isomatch::test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

TEST(Usage, VersionIsOneLine) {
  const Outcome outcome = run({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.output, "isomatch " ISOMATCH_VERSION "\n");
}

TEST(Usage, HelpListsSubcommands) {
  const Outcome outcome = run({"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* name : {"match", "info", "eval", "synth"})
    EXPECT_THAT(outcome.output, HasSubstr(name));
}

class SubcommandHelp : public testing::TestWithParam<const char*> {};

TEST_P(SubcommandHelp, HasExampleOfItself) {
  const std::string name = GetParam();
  const Outcome outcome = run({name, "--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("Usage: isomatch " + name));
  EXPECT_THAT(outcome.output, HasSubstr("Example:\n  isomatch " + name + " "));
  EXPECT_EQ(outcome.errors, "");
}

INSTANTIATE_TEST_SUITE_P(Usage, SubcommandHelp, testing::Values("match", "info", "eval", "synth"));

class WrongUsage : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(WrongUsage, IsOneLineAndExitCodeTwo) {
  const Outcome outcome = run(GetParam());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.output, "");
  EXPECT_THAT(outcome.errors, MatchesRegex("isomatch: [^\n]+\n"));
}

INSTANTIATE_TEST_SUITE_P(
    Usage, WrongUsage,
    testing::Values(std::vector<std::string>{}, std::vector<std::string>{"frobnicate"},
                    std::vector<std::string>{"info"}, std::vector<std::string>{"info", "--wrong"},
                    std::vector<std::string>{"info", "a.off", "b.off"},
                    std::vector<std::string>{"eval", "a.off", "b.off"},
                    std::vector<std::string>{"eval", "a", "b", "m", "--threads", "0"},
                    std::vector<std::string>{"eval", "a", "b", "m", "--threads", "many"},
                    std::vector<std::string>{"eval", "a", "b", "m", "--list", "0"},
                    std::vector<std::string>{"eval", "a", "b", "m", "--gt-source", "a.vts"}));

}  // namespace
}  // namespace isomatch::test
