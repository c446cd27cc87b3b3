// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "batch_fixture.h"
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

TEST_F(Batch, LeavesWhatMatchDoesForEachPair) {
  ASSERT_EQ(whole_->exit_code, kNothingToDo) << whole_->errors;
  EXPECT_THAT(whole_->output, HasSubstr("6 of 6 pairs matched"));
  ASSERT_EQ(run({"match", shape("c.off"), shape("a.off"), "-o", path("one")}).exit_code, 0);
  EXPECT_EQ(map(shared_->path("whole/c__a")), map(path("one")));
  EXPECT_EQ(read_file(shared_->path("whole/c__a/registered.ply")),
            read_file(path("one/registered.ply")));
  copy_whole("out");
  const std::vector<std::string> table = lines("out/pairs.csv");
  ASSERT_EQ(table.size(), 7);
  EXPECT_THAT(table[0], StartsWith("name,source,target,outcome,fit,"));
  EXPECT_THAT(table[5], StartsWith("c__a," + shape("c.off")));
  EXPECT_THAT(table[5], HasSubstr(",matched,good,"));
}

/// The same error as by `isomatch eval`; the maps know nothing of it.
TEST_F(Batch, MeasuresAgainstTheTruth) {
  fs::create_directories(path("truth"));
  std::string truth;  // They have vertex for vertex in common.
  for (int vertex = 0; vertex < lump(0).num_vertices(); ++vertex)
    truth += std::to_string(vertex + 1) + "\n";
  for (const char* name : {"truth/a.vts", "truth/b.vts"}) folder_.write(name, truth);
  folder_.write("pairs.txt", shape("a.off") + " " + shape("b.off") + "\n");
  ASSERT_EQ(batch("out", {path("pairs.txt"), "--truth", path("truth")}).exit_code, 0);
  EXPECT_EQ(map(path("out/a__b")), map(shared_->path("whole/a__b")));
  const Outcome eval =
      run({"eval", shape("a.off"), shape("b.off"), path("out/a__b/source_to_target.bary.txt"),
           "--gt-source", path("truth/a.vts"), "--gt-target", path("truth/b.vts"), "--json"});
  const auto json = nlohmann::json::parse(eval.output);
  const double mean = json["ground_truth"]["point_error_over_sqrt_area"]["mean"];
  EXPECT_GT(mean, 0);
  EXPECT_NEAR(std::stod(column("out/pairs.csv", "point_error_over_sqrt_area")), mean, 1e-5 * mean);
  EXPECT_GT(std::stod(column("out/pairs.csv", "peak_memory_mib")), 5);
  const double confidence = std::stod(column("out/pairs.csv", "mean_confidence"));
  EXPECT_GT(confidence, 0.2);
  EXPECT_LE(confidence, 1);
  const Outcome missing = all("other", {"--truth", path("truth")});
  EXPECT_EQ(missing.exit_code, kBadInput);
  EXPECT_THAT(missing.errors, HasSubstr("c.vts: is not there: --truth needs one for"));
  EXPECT_FALSE(fs::exists(path("other")));
}

TEST_F(Batch, FailsThePairsOfABadFileAndNoOther) {
  folder_.write("bad.off", "OFF\n3 1 0\n0 0 zero\n");
  folder_.write("pairs.txt", shape("a.off") + " bad.off\n" + shape("a.off") + " " + shape("b.off") +
                                 "\nno.off " + shape("b.off") + "\n");
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
  expect_maps_of_whole("out");
}

TEST_F(Batch, KeepsWhatIsFinished) {
  copy_whole("out");
  const auto written = fs::last_write_time(path("out/b__c/report.json"));
  fs::remove_all(path("out/a__b"));
  const Outcome outcome = all("out", {"--resume"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("b__c: good fit (earlier)"));
  EXPECT_EQ(fs::last_write_time(path("out/b__c/report.json")), written);
  expect_maps_of_whole("out");
}

TEST_F(Batch, RefusesAFolderOfAnotherBatch) {
  copy_whole("out");
  const Outcome again = all("out");
  EXPECT_EQ(again.exit_code, kBadInput);
  EXPECT_THAT(again.errors, HasSubstr("holds a batch already: --resume goes on with it"));
  const Outcome other = all("out", {"--resume", "--no-orientation"});
  EXPECT_EQ(other.exit_code, kBadInput);
  EXPECT_THAT(other.errors, HasSubstr("a batch of other options or of another version"));
}

/// Neither how many threads there are nor what is kept changes a map.
TEST_F(Batch, SharesTogetherAreTheWhole) {
  ASSERT_EQ(all("out", {"--shard", "1/2", "--threads", "1", "--memory", "0"}).exit_code, 0);
  EXPECT_EQ(lines("out/pairs-1-of-2.csv").size(), 4);
  const Outcome early = all("out", {"--merge"});
  EXPECT_EQ(early.exit_code, kPartlyFailed);
  EXPECT_THAT(read_file(path("out/pairs.csv")), HasSubstr(",failed,,,,,,,,,,,,,,not matched yet"));
  ASSERT_EQ(all("out", {"--shard", "2/2", "--threads", "3"}).exit_code, 0);
  ASSERT_EQ(all("out", {"--merge"}).exit_code, 0);
  EXPECT_EQ(lines("out/pairs.csv").size(), 7);
  expect_maps_of_whole("out");
}

TEST_F(Batch, DoesNotTakeResultsOfOtherShapesOrBrokenOnesForItsOwn) {
  folder_.write("pairs.txt", shape("a.off") + " " + shape("b.off") + " x\n" + shape("a.off") + " " +
                                 shape("c.off") + " y\n");
  ASSERT_EQ(batch("out", {path("pairs.txt")}).exit_code, 0);
  folder_.write("pairs.txt", shape("b.off") + " " + shape("a.off") + " x\n" + shape("a.off") + " " +
                                 shape("c.off") + " y\n");
  EXPECT_EQ(batch("out", {path("pairs.txt"), "--resume"}).exit_code, kPartlyFailed);
  EXPECT_THAT(lines("out/pairs.csv")[1], HasSubstr("the result of other shapes or options"));
  EXPECT_THAT(lines("out/pairs.csv")[2], HasSubstr(",matched,"));
  for (const char* content : {"", "{", "{}", "null", "[]"}) {
    folder_.write("out/x/report.json", content);
    for (const char* way : {"--resume", "--merge"}) {
      EXPECT_EQ(batch("out", {path("pairs.txt"), way}).exit_code, kPartlyFailed) << content;
      EXPECT_THAT(lines("out/pairs.csv")[1], HasSubstr("it is no whole result; remove it"));
      EXPECT_THAT(lines("out/pairs.csv")[2], HasSubstr(",matched,"));
    }
  }
}

TEST_F(Batch, OverwritesNeitherItsListNorFilesOfOthers) {
  const std::string content = shape("a.off") + "," + shape("b.off") + "\n";
  folder_.write("pairs.csv", content);
  const Outcome list = batch("", {path("pairs.csv")});
  EXPECT_EQ(list.exit_code, kBadInput);
  EXPECT_EQ(read_file(path("pairs.csv")), content);
  fs::create_directories(path("out"));
  folder_.write("out/batch.log", "mine");
  const Outcome log = all("out");
  EXPECT_EQ(log.exit_code, kBadInput);
  EXPECT_THAT(log.errors, HasSubstr("batch.log: isomatch did not write this file"));
  EXPECT_EQ(read_file(path("out/batch.log")), "mine");
}

TEST_F(Batch, MergesNothingWhereThereIsNoBatch) {
  const Outcome outcome = all("typo", {"--merge"});
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, HasSubstr("holds no batch"));
  EXPECT_FALSE(fs::exists(path("typo")));
}

TEST_F(Batch, RefusesSharesThatAreNone) {
  for (const char* shard : {"0/2", "3/2", "1", "1/2x", "a/b", " 1/2", "1/99999999999"}) {
    const Outcome outcome = all("out", {"--shard", shard});
    EXPECT_EQ(outcome.exit_code, kBadInput) << shard;
    EXPECT_THAT(outcome.errors, HasSubstr("--shard: expected I/N")) << shard;
  }
}

}  // namespace
}  // namespace isomatch::test
