// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>

#include <set>

#include "match_program.h"
#include "program.h"

namespace isomatch::test {
namespace {

using testing::HasSubstr;

class MatchPaper : public MatchProgram {
 protected:
  std::vector<std::string> arguments(const std::string& folder,
                                     std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--method", "paper"});
    return MatchProgram::arguments(folder, more);
  }
};

TEST_F(MatchPaper, MatchesEveryVertexOfTheLargestComponents) {
  const Outcome outcome = run(arguments("out"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, HasSubstr("D_iso"));
  EXPECT_THAT(outcome.output, HasSubstr("2 components"));
  const VertexMap map = read_map(path("out/source_to_target.txt"), counts()).source_to_target;
  for (int t : map) EXPECT_GE(t, 4);
  std::set<int> sources, targets;
  const MatchContent relation = read_matches(path("out/correspondence.txt"), counts());
  for (const Match& match : relation.matches) {
    sources.insert(match.source);
    targets.insert(match.target);
  }
  EXPECT_EQ(std::ssize(sources), source_.num_vertices());
  EXPECT_EQ(std::ssize(targets), target_.num_vertices() - 4);
  EXPECT_EQ(*targets.begin(), 4);
}

TEST_F(MatchPaper, VerticesOutsideTheMatchedComponentAreUnmatched) {
  const Outcome outcome = run({"match", path("target.ply"), path("source.off"), "-o", path("out"),
                               "--method", "paper", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
  const VertexMap map = read_map(path("out/source_to_target.txt"),
                                 {target_.num_vertices(), source_.num_vertices(), std::nullopt})
                            .source_to_target;
  for (int v = 0; v < target_.num_vertices(); ++v) EXPECT_EQ(map[v] == kUnmatched, v < 4);
}

TEST_F(MatchPaper, ReportsEveryLevel) {
  ASSERT_EQ(run(arguments("out", {"--levels", "3"})).exit_code, 0);
  const nlohmann::json levels = json("out/levels.json");
  ASSERT_EQ(levels.size(), 4);
  for (int k = 0; k < 4; ++k) {
    const std::string stem = "out/levels/0" + std::to_string(k);
    const Correspondence matches =
        read_matches(path(stem + ".correspondence.txt"), counts()).matches;
    EXPECT_EQ(levels[k]["matches"], matches.size());
    const Correspondence many_to_one =
        read_matches(path(stem + ".many_to_one.txt"), counts()).matches;
    EXPECT_EQ(levels[k]["source_bases"], many_to_one.size());
  }
  const nlohmann::json report = json("out/report.json");
  EXPECT_EQ(report["options"]["levels"], 3);
  EXPECT_EQ(report["complete"], false);
  EXPECT_EQ(report["target"]["given"]["components"], 2);
  EXPECT_GT(report["peak_memory_mib"], 1);
  EXPECT_GT(report["seconds"]["merging"], 0);
}

TEST_F(MatchPaper, ThreadsChangeNoByte) {
  ASSERT_EQ(run(arguments("one", {"--threads", "1"})).exit_code, 0);
  ASSERT_EQ(run(arguments("three", {"--threads", "3"})).exit_code, 0);
  for (const char* name : {"source_to_target.txt", "correspondence.txt", "levels.json"})
    EXPECT_EQ(bytes(std::string("one/") + name), bytes(std::string("three/") + name)) << name;
}

}  // namespace
}  // namespace isomatch::test
