// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "batch_fixture.h"

namespace isomatch::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr int kNothingToDo = 0, kBadInput = 2, kPartlyFailed = 3, kKilled = 137;

/// Results that go into an archive, read by the program of SQLite.
class PackedBatch : public Batch {
 protected:
  static void SetUpTestSuite() {
    Batch::SetUpTestSuite();
    const Outcome outcome =
        run({"batch", "--all", shared_->path("shapes"), "-o", shared_->path("packed"), "--packed"});
    EXPECT_EQ(outcome.exit_code, kNothingToDo) << outcome.errors;
  }

  // Temporary files of processes that are killed go where all else is removed.
  void SetUp() override {
    if (const char* const before = std::getenv("TMPDIR")) before_ = before;
    fs::create_directories(path("tmp"));
    setenv("TMPDIR", path("tmp").c_str(), 1);
  }
  void TearDown() override {
    if (before_)
      setenv("TMPDIR", before_->c_str(), 1);
    else
      unsetenv("TMPDIR");
  }

  /// A copy of all that is matched, in an archive.
  void copy_packed(const std::string& folder) const {
    fs::copy(shared_->path("packed"), path(folder), fs::copy_options::recursive);
  }

  Outcome packed(const std::string& folder, std::vector<std::string> words = {},
                 const RunOptions& options = {}) const {
    words.emplace_back("--packed");
    return all(folder, words, options);
  }

  /// Of `sqlite3 -A`.
  Outcome sqlite(std::vector<std::string> words) const {
    return run(words, {.program = "/usr/bin/sqlite3"});
  }
  std::vector<std::string> names(const std::string& archive) const {
    const Outcome outcome = sqlite({path(archive), "-At"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    std::istringstream text(outcome.output);
    std::vector<std::string> names;
    for (std::string line; std::getline(text, line);) names.push_back(line);
    return names;
  }
  void extract(const std::string& archive, const std::string& folder) const {
    fs::create_directories(path(folder));
    const Outcome outcome = sqlite({"-A", "-x", "-f", path(archive), "-C", path(folder)});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  }

  /// Of all in a folder, sorted.
  std::vector<std::string> names_in(const std::string& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path(folder)))
      names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
  }

  /// How many files each pair has.
  std::map<std::string, int> files_of_pairs(const std::string& archive) const {
    std::map<std::string, int> files;
    for (const std::string& name : names(archive)) ++files[name.substr(0, name.find('/'))];
    return files;
  }

  void expect_refused(const std::string& message) const {
    for (const char* way : {"--resume", "--merge"}) {
      const Outcome outcome = packed("out", {way});
      EXPECT_EQ(outcome.exit_code, kBadInput) << way;
      EXPECT_THAT(outcome.errors, HasSubstr(message)) << way;
    }
  }

 private:
  std::optional<std::string> before_;
};

TEST_F(PackedBatch, HoldsTheBytesThatFoldersDo) {
  copy_packed("out");
  EXPECT_THAT(names_in("out"),
              testing::ElementsAre("batch.json", "batch.log", "pairs.csv", "results.sqlar"));
  EXPECT_EQ(lines("out/pairs.csv").size(), 7);
  extract("out/results.sqlar", "extracted");
  int compared = 0;
  for (const auto& entry : fs::recursive_directory_iterator(shared_->path("whole"))) {
    const fs::path name = entry.path().lexically_relative(shared_->path("whole"));
    if (!entry.is_regular_file() || !name.has_parent_path()) continue;
    const std::string file = path("extracted/" + name.string());
    ASSERT_TRUE(fs::exists(file)) << name;
    if (name.filename() == "report.json") continue;  // Has seconds.
    EXPECT_EQ(read_file(file), read_file(entry.path().string())) << name;
    ++compared;
  }
  EXPECT_GE(compared, 6 * 5);
  EXPECT_EQ(names("out/results.sqlar").size(), compared + 6);
  ASSERT_EQ(run({"eval", shape("a.off"), shape("b.off"),
                 path("extracted/a__b/source_to_target.bary.txt")})
                .exit_code,
            0);
}

TEST_F(PackedBatch, LeavesNothingAmongTemporaryFiles) {
  folder_.write("pairs.txt",
                shape("a.off") + " " + shape("b.off") + "\n" + shape("a.off") + " no.off\n");
  EXPECT_EQ(batch("failed", {path("pairs.txt"), "--packed"}).exit_code, kPartlyFailed);
  EXPECT_EQ(packed("stopped", {}, {.interrupt_after = std::chrono::milliseconds(300)}).exit_code,
            128 + SIGINT);
  EXPECT_THAT(names_in("tmp"), testing::IsEmpty());
  fs::remove(path("tmp"));
  const Outcome outcome = packed("nowhere");
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("TMPDIR"));
}

TEST_F(PackedBatch, GoesOnWhereItWasKilled) {
  int killed = 0;
  int files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(shared_->path("whole/a__b")))
    ++files;
  for (const int milliseconds : {300, 450, 600, 750}) {
    const Outcome outcome =
        packed("out", {"--resume", "--threads", "1"},
               {.interrupt_after = std::chrono::milliseconds(milliseconds), .signal = SIGKILL});
    if (outcome.exit_code == kKilled) ++killed;
    if (!fs::exists(path("out/results.sqlar"))) continue;
    for (const auto& [pair, count] : files_of_pairs("out/results.sqlar"))
      EXPECT_EQ(count, files) << pair;
  }
  EXPECT_GT(killed, 0);
  ASSERT_EQ(packed("out", {"--resume"}).exit_code, 0);
  extract("out/results.sqlar", "extracted");
  expect_maps_of_whole("extracted");
}

/// A share each, folders and archives: it does not matter where a pair is finished.
TEST_F(PackedBatch, MergesArchivesAndFolders) {
  ASSERT_EQ(packed("out", {"--shard", "1/3"}).exit_code, 0);
  EXPECT_EQ(packed("out", {"--merge"}).exit_code, kPartlyFailed);
  ASSERT_EQ(packed("out", {"--shard", "2/3"}).exit_code, 0);
  ASSERT_EQ(all("out", {"--shard", "3/3"}).exit_code, 0);
  ASSERT_EQ(all("out", {"--merge"}).exit_code, 0);
  EXPECT_EQ(lines("out/pairs.csv").size(), 7);
  EXPECT_THAT(read_file(path("out/pairs.csv")), Not(HasSubstr(",failed,")));
  for (const auto& words : {std::vector<std::string>{}, {"--packed"}}) {
    std::vector<std::string> resumed = words;
    resumed.emplace_back("--resume");
    const Outcome outcome = all("out", resumed);
    EXPECT_EQ(outcome.exit_code, 0);
    for (const char* pair : {"a__b", "a__c", "b__a", "b__c", "c__a", "c__b"})
      EXPECT_THAT(outcome.output, HasSubstr(std::string(pair) + ": good fit (earlier)"));
  }
}

TEST_F(PackedBatch, RefusesWhatIsNoArchiveInOneLine) {
  copy_packed("out");
  const std::string whole = read_file(path("out/results.sqlar"));
  const std::string message = "results.sqlar: is no SQLite archive, or is damaged";
  folder_.write("out/results.sqlar", "these are no results\n");
  expect_refused(message);
  folder_.write("out/results.sqlar", whole.substr(0, whole.size() / 2));
  expect_refused(message);
  fs::remove(path("out/results.sqlar"));
  sqlite({path("out/results.sqlar"), "CREATE TABLE other(name)"});
  expect_refused(message);
  fs::remove(path("out/results.sqlar"));
  fs::create_directories(path("out/results.sqlar"));
  expect_refused("results.sqlar: ");
  fs::remove(path("out/results.sqlar"));
  // What is left if it was killed at once.
  folder_.write("out/results.sqlar", "");
  EXPECT_EQ(all("out", {"--merge"}).exit_code, kPartlyFailed);
  EXPECT_THAT(lines("out/pairs.csv")[1], HasSubstr("not matched yet"));
}

/// Wherever bytes of it are wrong, a pair is refused or its report is read.
TEST_F(PackedBatch, SurvivesDamage) {
  copy_packed("out");
  const std::string whole = read_file(path("out/results.sqlar"));
  for (std::size_t at = 0; at < whole.size(); at += whole.size() / 25) {
    std::string damaged = whole;
    for (std::size_t i = at; i < std::min(whole.size(), at + 700); ++i) damaged[i] ^= '\x5a';
    folder_.write("out/results.sqlar", damaged);
    const Outcome outcome = all("out", {"--merge"});
    EXPECT_THAT(outcome.exit_code, testing::AnyOf(0, kBadInput, kPartlyFailed)) << at;
  }
}

TEST_F(PackedBatch, SaysThatAnotherProcessLocksIt) {
  copy_packed("out");
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path("out/results.sqlar").c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, "BEGIN EXCLUSIVE", nullptr, nullptr, nullptr), SQLITE_OK);
  const Outcome outcome = packed("out", {"--resume"});
  EXPECT_EQ(sqlite3_close(database), SQLITE_OK);
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("results.sqlar: is locked by another process"));
}

TEST_F(PackedBatch, OverwritesNoArchiveOfOthers) {
  fs::create_directories(path("out"));
  folder_.write("out/results.sqlar", "mine");
  const Outcome outcome = packed("out");
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("isomatch did not write this file"));
  EXPECT_EQ(read_file(path("out/results.sqlar")), "mine");
}

TEST_F(PackedBatch, TakesNoResultOfOtherShapesForItsOwn) {
  folder_.write("pairs.txt", shape("a.off") + " " + shape("b.off") + " x\n");
  ASSERT_EQ(batch("out", {path("pairs.txt"), "--packed"}).exit_code, 0);
  folder_.write("pairs.txt", shape("b.off") + " " + shape("a.off") + " x\n");
  EXPECT_EQ(batch("out", {path("pairs.txt"), "--packed", "--resume"}).exit_code, kPartlyFailed);
  EXPECT_THAT(lines("out/pairs.csv")[1],
              HasSubstr("results.sqlar/x: is in the way: it is the result of other shapes"));
}

/// Both write the same archive at the same time.
TEST_F(PackedBatch, TwoProcessesLeaveEachPairOnce) {
  Outcome other;
  {
    const std::jthread second([&] { other = packed("out", {"--shard", "1/1"}); });
    EXPECT_EQ(packed("out", {"--shard", "1/1"}).exit_code, 0);
  }
  EXPECT_EQ(other.exit_code, 0) << other.errors;
  EXPECT_EQ(files_of_pairs("out/results-1-of-1.sqlar").size(), 6);
  extract("out/results-1-of-1.sqlar", "extracted");
  expect_maps_of_whole("extracted");
}

}  // namespace
}  // namespace isomatch::test
