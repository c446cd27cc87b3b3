// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>

#include <filesystem>

#include "match_program.h"
#include "program.h"

namespace isomatch::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::string_view kManifest = R"(<script type="application/json" id="isomatch-manifest">)";

/// Runs of the program without and, if the viewer was bundled, with the page.
class Report : public MatchProgram {
 protected:
  void SetUp() override {
    MatchProgram::SetUp();
    write_map(path("source.vts"), {.source_to_target = creature(1).ground_truth});
    std::vector<int> target = creature(2).ground_truth;
    for (int& vertex : target) vertex += kExtraVertices;
    write_map(path("target.vts"), {.source_to_target = target});
  }

  std::vector<std::string> truth() const {
    return {"--gt-source", path("source.vts"), "--gt-target", path("target.vts")};
  }

  Outcome report(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"report", path("out")});
    return run(more);
  }

  nlohmann::json manifest() const {
    const std::string page = bytes("out/report.html");
    const std::size_t start = page.find(kManifest) + kManifest.size();
    return nlohmann::json::parse(page.substr(start, page.find("</script>", start) - start));
  }

  /// Largest value of a kind that a map's entry names.
  static double largest(const nlohmann::json& map, const char* name) { return map.at(name); }
};

class ReportWithPage : public Report {
 protected:
  void SetUp() override {
    if (!ISOMATCH_HAS_PAGE) GTEST_SKIP() << "built without the viewer; run scripts/build_viewer.sh";
    Report::SetUp();
  }
};

TEST_F(ReportWithPage, ShowsAMatchByTheTrackedMethod) {
  ASSERT_EQ(run(arguments("out", {"--alternatives", "2"})).exit_code, 0);
  const Outcome outcome = report(truth());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "written to " + path("out/report.html") + "\n");
  const nlohmann::json page = manifest();
  EXPECT_EQ(page["report"], json("out/report.json"));
  EXPECT_EQ(page["source"]["vertices"], source_.num_vertices());
  EXPECT_EQ(page["target"]["faces"], target_.num_faces());
  EXPECT_EQ(page["maps"].size(), 1 + json("out/report.json")["alternatives"].size());
  EXPECT_TRUE(page["levels"].empty());
  EXPECT_GT(largest(page["maps"][0], "d_iso_max"), 0);
  EXPECT_LT(largest(page["maps"][0], "d_iso_max"), 0.5);
  EXPECT_GT(largest(page["maps"][0], "error_max"), 0);
  EXPECT_LT(largest(page["maps"][0], "error_max"), 3);
  EXPECT_EQ(page["maps"][0]["confidence"], true);
}

TEST_F(ReportWithPage, ShowsTheLevelsOfThePaper) {
  const Outcome outcome = run(arguments("out", {"--method", "paper", "--levels", "3", "--report"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("to look at it, open " + path("out/report.html")));
  const nlohmann::json page = manifest(), levels = json("out/levels.json");
  ASSERT_EQ(page["levels"].size(), 4U);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(page["levels"][k]["matches"], levels[k]["matches"]);
  EXPECT_FALSE(page["maps"][0].contains("registered"));
  EXPECT_EQ(page["maps"][0]["confidence"], false);
  EXPECT_EQ(page["truth"], nullptr);
}

TEST_F(ReportWithPage, AMatchMakesThePageThatItsFolderWouldGive) {
  for (const std::vector<std::string>& method :
       {std::vector<std::string>{"--alternatives", "2", "--target-to-source"},
        {"--method", "paper", "--levels", "3"}}) {
    std::vector<std::string> more = truth();
    more.emplace_back("--report");
    more.insert(more.end(), method.begin(), method.end());
    ASSERT_EQ(run(arguments("out", more)).exit_code, 0);
    const std::string page = bytes("out/report.html"), listed = bytes("out/report.json");
    ASSERT_EQ(report(truth()).exit_code, 0);
    EXPECT_EQ(bytes("out/report.html"), page) << method.front();
    EXPECT_EQ(bytes("out/report.json"), listed) << method.front();
  }
}

TEST_F(ReportWithPage, ThreadsChangeNoByte) {
  ASSERT_EQ(run(arguments("out")).exit_code, 0);
  ASSERT_EQ(report({"--threads", "1", "-q", "-o", path("one.html")}).exit_code, 0);
  ASSERT_EQ(report({"--threads", "3", "-q", "-o", path("three.html")}).exit_code, 0);
  EXPECT_EQ(bytes("one.html"), bytes("three.html"));
}

TEST_F(ReportWithPage, ALaterMatchRemovesThePage) {
  ASSERT_EQ(run(arguments("out", {"--report"})).exit_code, 0);
  EXPECT_TRUE(fs::exists(path("out/report.html")));
  ASSERT_EQ(run(arguments("out")).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("out/report.html")));
}

TEST_F(ReportWithPage, BadInputIsNamed) {
  EXPECT_THAT(report().errors, HasSubstr("is this the folder of a match?"));
  ASSERT_EQ(run(arguments("out", {"--method", "paper", "--levels", "1"})).exit_code, 0);
  EXPECT_THAT(report({"--gt-source", path("source.vts")}).errors, HasSubstr("--gt-target"));
  folder_.write("short.vts", "1\n2\n");
  EXPECT_THAT(report({"--gt-source", path("source.vts"), "--gt-target", path("short.vts")}).errors,
              HasSubstr("2 template points, but"));
  folder_.write("out/levels/01.correspondence.txt", "0 5 0.1\n0 nose 0.1\n");
  const Outcome outcome = report();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("01.correspondence.txt: line 2: expected two vertices"));
}

TEST_F(Report, OptionsOfThePageNeedIt) {
  std::vector<std::string> all = arguments("out");
  for (const std::string& word : truth()) all.push_back(word);
  const Outcome outcome = run(all);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("is of use with --report only"));
}

TEST_F(Report, AProgramBuiltWithoutThePageSaysWhatIsMissing) {
  std::vector<std::string> match = arguments("out", {"--report"});
  const Outcome refused = run(match, {.program = program_without_page()});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("install Node.js and npm, run scripts/build_viewer.sh"));
  EXPECT_FALSE(fs::exists(path("out"))) << "refused before the work";
  match.pop_back();
  ASSERT_EQ(run(match, {.program = program_without_page()}).exit_code, 0);
  const Outcome report = run({"report", path("out")}, {.program = program_without_page()});
  EXPECT_EQ(report.exit_code, 2);
  EXPECT_THAT(report.errors, HasSubstr("built without the report's page"));
}

}  // namespace
}  // namespace isomatch::test
