// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "isomatch/map_io.h"
#include "isomatch/mesh_io.h"
#include "isomatch/synth.h"
#include "program.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"
#include "support/transforms.h"

namespace isomatch::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Mesh creature(int pose) { return synthesize({.vertices = 1000, .pose = pose, .seed = 2}).mesh; }

/// A creature in two poses; to the target a small tetrahedron is added, with the lowest numbers.
class MatchProgram : public testing::Test {
 protected:
  void SetUp() override {
    write_mesh(path("source.off"), source_);
    write_mesh(path("target.ply"), target_);
  }

  std::string path(const std::string& name) const { return folder_.path(name); }

  std::vector<std::string> arguments(const std::string& folder,
                                     const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"match", path("source.off"), path("target.ply"), "-o",
                                 path(folder)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(bytes(path(name)));
  }

  VertexCounts counts() const { return {source_.num_vertices(), target_.num_vertices()}; }

  const Mesh source_ = creature(1);
  const Mesh target_ = combined(scaled(tetrahedron(), 0.01), creature(2));
  TemporaryFolder folder_;
};

TEST_F(MatchProgram, MatchesEveryVertexOfTheLargestComponents) {
  const Outcome outcome = run(arguments("out"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, HasSubstr("D_iso"));
  EXPECT_THAT(outcome.output, HasSubstr("2 components"));
  const VertexMap map = read_source_to_target(path("out/source_to_target.txt"), counts());
  for (int t : map) EXPECT_GE(t, 4);
  std::set<int> sources, targets;
  for (const Match& match : read_correspondence(path("out/correspondence.txt"), counts())) {
    sources.insert(match.source);
    targets.insert(match.target);
  }
  EXPECT_EQ(std::ssize(sources), source_.num_vertices());
  EXPECT_EQ(std::ssize(targets), target_.num_vertices() - 4);
  EXPECT_EQ(*targets.begin(), 4);
}

TEST_F(MatchProgram, VerticesOutsideTheMatchedComponentAreUnmatched) {
  const Outcome outcome =
      run({"match", path("target.ply"), path("source.off"), "-o", path("out"), "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
  const VertexMap map = read_source_to_target(path("out/source_to_target.txt"),
                                              {target_.num_vertices(), source_.num_vertices()});
  for (int v = 0; v < target_.num_vertices(); ++v) EXPECT_EQ(map[v] == kUnmatched, v < 4);
}

TEST_F(MatchProgram, ReportsEveryLevel) {
  ASSERT_EQ(run(arguments("out", {"--levels", "3"})).exit_code, 0);
  const nlohmann::json levels = json("out/levels.json");
  ASSERT_EQ(levels.size(), 4);
  for (int k = 0; k < 4; ++k) {
    const std::string stem = "out/levels/0" + std::to_string(k);
    const Correspondence matches =
        read_correspondence(path(stem + ".correspondence.txt"), counts());
    EXPECT_EQ(levels[k]["matches"], matches.size());
    const Correspondence many_to_one =
        read_correspondence(path(stem + ".many_to_one.txt"), counts());
    EXPECT_EQ(levels[k]["source_bases"], many_to_one.size());
  }
  const nlohmann::json report = json("out/report.json");
  EXPECT_EQ(report["options"]["levels"], 3);
  EXPECT_EQ(report["complete"], false);
  EXPECT_EQ(report["target"]["given"]["components"], 2);
  EXPECT_GT(report["peak_memory_mib"], 1);
  EXPECT_GT(report["seconds"]["merging"], 0);
}

TEST_F(MatchProgram, ThreadsChangeNoByte) {
  ASSERT_EQ(run(arguments("one", {"--threads", "1"})).exit_code, 0);
  ASSERT_EQ(run(arguments("three", {"--threads", "3"})).exit_code, 0);
  for (const char* name : {"source_to_target.txt", "correspondence.txt", "levels.json"})
    EXPECT_EQ(bytes(path("one/") + name), bytes(path("three/") + name)) << name;
}

TEST_F(MatchProgram, BadInputLeavesNoFolder) {
  folder_.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  const Outcome truncated = run({"match", path("source.off"), path("bad.off"), "-o", path("out")});
  EXPECT_EQ(truncated.exit_code, 2);
  EXPECT_THAT(truncated.errors, HasSubstr("bad.off: line 2"));
  folder_.write("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  const Outcome flat = run({"match", path("source.off"), path("flat.off"), "-o", path("out")});
  EXPECT_EQ(flat.exit_code, 2);
  EXPECT_THAT(flat.errors, HasSubstr("flat.off"));
  EXPECT_EQ(run(arguments("out", {"--max-coarse-bases", "0"})).exit_code, 2);
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(MatchProgram, OutputThatCannotBeMadeIsRefusedFirst) {
  const Outcome missing = run(arguments("no/such/folder"));
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.errors, HasSubstr("cannot be created"));
  EXPECT_EQ(run(arguments("source.off")).exit_code, 2);
}

TEST_F(MatchProgram, InterruptLeavesNothingBroken) {
  write_mesh(path("source.off"), synthesize({.vertices = 30000, .pose = 1, .seed = 2}).mesh);
  const Outcome outcome =
      run(arguments("out"), {.interrupt_after = std::chrono::milliseconds(300)});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_FALSE(fs::exists(path("out")));
}

}  // namespace
}  // namespace isomatch::test
