// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "match_program.h"
#include "program.h"

namespace isomatch::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(MatchProgram, BadInputLeavesNoFolder) {
  folder_.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  const Outcome truncated = run({"match", path("source.off"), path("bad.off"), "-o", path("out")});
  EXPECT_EQ(truncated.exit_code, 2);
  EXPECT_THAT(truncated.errors, HasSubstr("bad.off: line 2"));
  folder_.write("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  const Outcome flat = run({"match", path("source.off"), path("flat.off"), "-o", path("out")});
  EXPECT_EQ(flat.exit_code, 2);
  EXPECT_THAT(flat.errors, HasSubstr("flat.off"));
  EXPECT_EQ(run(arguments("out", {"--method", "paper", "--max-coarse-bases", "0"})).exit_code, 2);
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(MatchProgram, OutputThatCannotBeMadeIsRefusedFirst) {
  const Outcome missing = run(arguments("source.off/such/folder"));
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.errors, HasSubstr("cannot be created"));
  EXPECT_EQ(run(arguments("source.off")).exit_code, 2);
}

TEST_F(MatchProgram, OptionsOfTheOtherMethodAreRefused) {
  for (const auto& [given, others] :
       {std::pair<std::vector<std::string>, const char*>{{"--levels", "3"}, "paper"},
        {{"--method", "tracked", "--list-size", "9"}, "paper"},
        {{"--method", "paper", "--target-to-source"}, "tracked"},
        {{"--method", "paper", "--alternatives", "0"}, "tracked"}}) {
    const Outcome outcome = run(arguments("out", given));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("belongs to --method " + std::string(others)));
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1);
  }
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(MatchProgram, HelpSaysWhichOptionBelongsToWhichMethod) {
  const std::string help = run({"match", "--help"}).output;
  const auto place = [&](const char* text) { return help.find(text); };
  EXPECT_LT(place("--threads"), place("Options of --method tracked:"));
  EXPECT_LT(place("Options of --method tracked:"), place("--landmarks"));
  EXPECT_LT(place("--landmarks"), place("Options of --method paper:"));
  EXPECT_LT(place("Options of --method paper:"), place("--geodesics"));
  EXPECT_LT(place("Options of --method paper:"), place("--levels"));
  EXPECT_LT(place("--levels"), std::string::npos);
}

/// Every kind of file that a match may leave, of a run with more alternatives and levels than now,
/// as its report lists them, and files of the user's.
class MatchAfterMatch : public MatchProgram, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    MatchProgram::SetUp();
    nlohmann::json listed = nlohmann::json::array();
    for (const std::string name :
         {"source_to_target.txt", "source_to_target.bary.txt", "target_to_source.txt",
          "target_to_source.bary.txt", "registered.ply", "correspondence.txt", "levels.json",
          "notes.txt", "levels/98.correspondence.txt", "levels/99.many_to_one.txt",
          "levels/99.notes.txt", "alternatives/8/source_to_target.txt",
          "alternatives/9/registered.ply", "alternatives/9/notes.txt"}) {
      fs::create_directories(fs::path(path("out/" + name)).parent_path());
      folder_.write("out/" + name, kStale);
      if (!name.ends_with("notes.txt")) listed.push_back(name);
    }
    folder_.write("out/report.json",
                  nlohmann::json{{"isomatch", "0"}, {"files", listed}, {"of", kStale}}.dump());
  }

  /// Files in the folder of results, by whether they hold what they held before.
  std::vector<std::string> files(bool stale) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(path("out"))) {
      const bool is_file = entry.is_regular_file();
      if (is_file &&
          (read_file(entry.path().string()).find("of another run") != std::string::npos) == stale)
        names.push_back(fs::relative(entry.path(), path("out")).string());
    }
    std::ranges::sort(names);
    return names;
  }

  static constexpr const char* kStale = "of another run";
};

TEST_P(MatchAfterMatch, LeavesNothingOfTheOtherRun) {
  ASSERT_EQ(run(arguments("out", {"--method", GetParam()})).exit_code, 0);
  EXPECT_THAT(files(true),
              testing::ElementsAre("alternatives/9/notes.txt", "levels/99.notes.txt", "notes.txt"));
  EXPECT_FALSE(fs::exists(path("out/alternatives/8")));
  std::vector<std::string> listed = json("out/report.json")["files"];
  std::ranges::sort(listed);
  EXPECT_EQ(files(false), listed);
}

TEST_P(MatchAfterMatch, ThatFailsLeavesAllAsItWas) {
  const std::vector<std::string> before = files(true);
  folder_.write("source.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  EXPECT_EQ(run(arguments("out", {"--method", GetParam()})).exit_code, 2);
  EXPECT_EQ(files(true), before);
  EXPECT_TRUE(files(false).empty());
}

INSTANTIATE_TEST_SUITE_P(All, MatchAfterMatch, testing::Values("tracked", "paper"));

class InterruptedMatch : public MatchProgram, public testing::WithParamInterface<const char*> {};

TEST_P(InterruptedMatch, LeavesNothingBroken) {
  write_mesh(path("source.off"), synthesize({.vertices = 30000, .pose = 1, .seed = 2}).mesh);
  const Outcome outcome = run(arguments("out", {"--method", GetParam()}),
                              {.interrupt_after = std::chrono::milliseconds(300)});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_FALSE(fs::exists(path("out")));
}

INSTANTIATE_TEST_SUITE_P(All, InterruptedMatch, testing::Values("tracked", "paper"));

}  // namespace
}  // namespace isomatch::test
