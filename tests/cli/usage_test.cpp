// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "program.h"

namespace isomatch::test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

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

TEST(Usage, HelpNeedsNoDashes) {
  EXPECT_EQ(run({"help"}).output, run({"--help"}).output);
  EXPECT_EQ(run({"help", "match"}).output, run({"match", "--help"}).output);
  EXPECT_EQ(run({"help"}).exit_code, 0);
  EXPECT_THAT(run({"help", "macth"}).errors,
              HasSubstr("unknown command 'macth'; did you mean match?"));
}

class HelpOfAll : public testing::TestWithParam<const char*> {};

TEST_P(HelpOfAll, HasNoMarksOfTheParser) {
  const std::string help = run({GetParam(), "--help"}).output;
  for (const char* mark : {"{false}", "[Option Group", "\n\n\n", "TEXT", "INT", "FLOAT", "Needs:"})
    EXPECT_THAT(help, Not(HasSubstr(mark)));
  EXPECT_THAT(help, testing::ContainsRegex("\nDocumentation: docs/[a-z]+\\.md"));
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    const bool is_command = line.find("isomatch ") != std::string::npos;
    EXPECT_TRUE(is_command || line.size() <= 80) << line;
  }
}

INSTANTIATE_TEST_SUITE_P(Usage, HelpOfAll,
                         testing::Values("match", "info", "eval", "synth", "render", "report",
                                         "transfer", "convert"));

/// The complaint without the program's name.
std::string complaint(const std::vector<std::string>& arguments) {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 2);
  return outcome.errors.substr(std::min(outcome.errors.size(), std::size_t{10}));
}

TEST(Usage, MisspeltCommandsAreGuessed) {
  EXPECT_EQ(complaint({"macth", "a", "b"}),
            "unknown command 'macth'; did you mean match? (see isomatch --help)\n");
  EXPECT_EQ(complaint({"conv", "a", "b"}),
            "unknown command 'conv'; did you mean convert? (see isomatch --help)\n");
  EXPECT_EQ(complaint({"frobnicate"}), "unknown command 'frobnicate' (see isomatch --help)\n");
  EXPECT_EQ(complaint({}), "there is no command (see isomatch --help)\n");
}

TEST(Usage, TwoFilesWithoutACommandAreAMatch) {
  EXPECT_EQ(
      complaint({"a.off", "b.off"}),
      "there is no command; did you mean isomatch match a.off b.off? (see isomatch --help)\n");
  EXPECT_THAT(complaint({"a.off", "b.off", "-o", "out"}), HasSubstr("isomatch match a.off b.off?"));
}

TEST(Usage, MisspeltOptionsAreGuessed) {
  for (const char* option : {"--landmark", "--landmarsk", "-landmarks", "--landmark=x"})
    EXPECT_THAT(complaint({"match", "a", "b", option, "x"}),
                HasSubstr("; did you mean --landmarks? (see isomatch match --help)\n"))
        << option;
  EXPECT_THAT(complaint({"match", "a", "b", "--landmark", "x"}),
              testing::StartsWith("unknown option --landmark; "));
  EXPECT_EQ(complaint({"info", "--frobnicate", "a"}),
            "unknown option --frobnicate (see isomatch info --help)\n");
}

TEST(Usage, WordsTooManyAreNamed) {
  EXPECT_EQ(complaint({"info", "a.off", "b.off"}),
            "there is one word too many, 'b.off' (see isomatch info --help)\n");
}

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
