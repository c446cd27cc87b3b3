// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "isomatch/io/mesh_io.h"
#include "isomatch/mesh/synth.h"
#include "program.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"

namespace isomatch::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr int kNothingToDo = 0, kBadInput = 2, kPartlyFailed = 3, kInterrupted = 130;

/// Three poses of a creature in a folder.
class Batch : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(path("shapes"));
    for (int pose = 0; pose < 3; ++pose)
      write_mesh(path("shapes/" + std::string(1, static_cast<char>('a' + pose)) + ".off"),
                 synthesize({.vertices = 1000, .pose = pose, .seed = 3}).mesh);
  }

  std::string path(const std::string& name) const { return folder_.path(name); }

  Outcome batch(const std::string& folder, std::vector<std::string> words,
                const RunOptions& options = {}) const {
    words.insert(words.begin(), "batch");
    words.insert(words.end(), {"-o", path(folder)});
    return run(words, options);
  }
  Outcome all(const std::string& folder, std::vector<std::string> words = {},
              const RunOptions& options = {}) const {
    words.insert(words.end(), {"--all", path("shapes")});
    return batch(folder, words, options);
  }

  std::string map(const std::string& folder) const {
    return read_file(path(folder + "/source_to_target.bary.txt"));
  }

  void expect_same_maps(const std::string& folder, const std::string& other) const {
    for (const char* pair : {"a__b", "a__c", "b__a", "b__c", "c__a", "c__b"})
      EXPECT_EQ(map(folder + "/" + pair), map(other + "/" + pair)) << pair;
  }

  /// Lines of a file, the first for column names.
  std::vector<std::string> lines(const std::string& name) const {
    std::vector<std::string> lines;
    std::istringstream text(read_file(path(name)));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  }

  TemporaryFolder folder_;
};

TEST_F(Batch, LeavesWhatMatchDoesForEachPair) {
  const Outcome outcome = all("out");
  ASSERT_EQ(outcome.exit_code, kNothingToDo) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("6 of 6 pairs matched"));
  ASSERT_EQ(run({"match", path("shapes/c.off"), path("shapes/a.off"), "-o", path("one")}).exit_code,
            0);
  EXPECT_EQ(map("out/c__a"), map("one"));
  EXPECT_EQ(read_file(path("out/c__a/registered.ply")), read_file(path("one/registered.ply")));
  const std::vector<std::string> table = lines("out/pairs.csv");
  ASSERT_EQ(table.size(), 7);
  EXPECT_THAT(table[0], StartsWith("name,source,target,outcome,fit,"));
  EXPECT_THAT(table[5], StartsWith("c__a," + path("shapes/c.off")));
  EXPECT_THAT(table[5], HasSubstr(",matched,good,"));
}

TEST_F(Batch, FailsThePairsOfABadFileAndNoOther) {
  folder_.write("shapes/bad.off", "OFF\n3 1 0\n0 0 zero\n");
  folder_.write(
      "pairs.txt",
      "shapes/a.off shapes/bad.off\nshapes/a.off shapes/b.off\nshapes/no.off shapes/b.off\n");
  const Outcome outcome = batch("out", {path("pairs.txt")});
  EXPECT_EQ(outcome.exit_code, kPartlyFailed);
  EXPECT_THAT(outcome.errors, HasSubstr("2 of 3 pairs failed"));
  EXPECT_FALSE(fs::exists(path("out/a__bad")));
  EXPECT_FALSE(fs::exists(path("out/.a__bad.unfinished")));
  EXPECT_TRUE(fs::exists(path("out/a__b/report.json")));
  const std::vector<std::string> table = lines("out/pairs.csv");
  EXPECT_THAT(table[1], HasSubstr(",failed,"));
  EXPECT_THAT(table[1], HasSubstr("bad.off: line 2"));
  EXPECT_THAT(table[2], HasSubstr(",matched,"));
  EXPECT_THAT(read_file(path("out/batch.log")), HasSubstr("no__b: failed: "));
}

TEST_F(Batch, GoesOnWhereItWasInterrupted) {
  ASSERT_EQ(all("whole").exit_code, 0);
  int interrupted = 0;
  for (const int milliseconds : {300, 500, 700}) {
    const Outcome outcome = all("out", {"--resume", "--threads", "1"},
                                {.interrupt_after = std::chrono::milliseconds(milliseconds)});
    if (outcome.exit_code == kInterrupted) ++interrupted;
    for (const auto& entry : fs::directory_iterator(path("out")))
      EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("unfinished")));
  }
  EXPECT_GT(interrupted, 0);
  ASSERT_EQ(all("out", {"--resume"}).exit_code, 0);
  expect_same_maps("out", "whole");
}

TEST_F(Batch, KeepsWhatIsFinished) {
  ASSERT_EQ(all("out").exit_code, 0);
  const auto written = fs::last_write_time(path("out/b__c/report.json"));
  fs::remove_all(path("out/a__b"));
  const Outcome outcome = all("out", {"--resume"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("b__c: good fit (earlier)"));
  EXPECT_EQ(fs::last_write_time(path("out/b__c/report.json")), written);
  EXPECT_TRUE(fs::exists(path("out/a__b/report.json")));
}

TEST_F(Batch, RefusesAFolderOfAnotherBatch) {
  ASSERT_EQ(all("out").exit_code, 0);
  const Outcome again = all("out");
  EXPECT_EQ(again.exit_code, kBadInput);
  EXPECT_THAT(again.errors, HasSubstr("holds a batch already: --resume goes on with it"));
  const Outcome other = all("out", {"--resume", "--no-orientation"});
  EXPECT_EQ(other.exit_code, kBadInput);
  EXPECT_THAT(other.errors, HasSubstr("a batch of other options or of another version"));
}

TEST_F(Batch, SharesTogetherAreTheWhole) {
  ASSERT_EQ(all("whole").exit_code, 0);
  ASSERT_EQ(all("out", {"--shard", "1/2"}).exit_code, 0);
  EXPECT_EQ(lines("out/pairs-1-of-2.csv").size(), 4);
  const Outcome early = all("out", {"--merge"});
  EXPECT_EQ(early.exit_code, kPartlyFailed);
  EXPECT_THAT(read_file(path("out/pairs.csv")), HasSubstr(",failed,,,,,,,,,,not matched yet"));
  ASSERT_EQ(all("out", {"--shard", "2/2"}).exit_code, 0);
  ASSERT_EQ(all("out", {"--merge"}).exit_code, 0);
  EXPECT_EQ(lines("out/pairs.csv").size(), 7);
  expect_same_maps("out", "whole");
}

TEST_F(Batch, HasTheSameBytesWhateverIsKeptAndHoweverManyThreads) {
  ASSERT_EQ(all("out", {"--threads", "1", "--memory", "0"}).exit_code, 0);
  ASSERT_EQ(all("other", {"--threads", "3"}).exit_code, 0);
  expect_same_maps("out", "other");
}

TEST_F(Batch, RefusesSharesThatAreNone) {
  for (const char* shard : {"0/2", "3/2", "1", "1/2x", "a/b"}) {
    const Outcome outcome = all("out", {"--shard", shard});
    EXPECT_EQ(outcome.exit_code, kBadInput) << shard;
    EXPECT_THAT(outcome.errors, HasSubstr("--shard: expected I/N")) << shard;
  }
}

}  // namespace
}  // namespace isomatch::test
