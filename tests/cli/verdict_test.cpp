// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "match_program.h"
#include "program.h"

namespace isomatch::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Of a creature the template points that lie farthest in front and behind.
struct Ends {
  int front, behind;
};

Ends ends_of(const SynthShape& shape) {
  const auto z = [&](int v) { return shape.rest[v][2]; };
  const auto [behind, front] = std::ranges::minmax_element(shape.ground_truth, {}, z);
  return {*front, *behind};
}

class Verdict : public MatchProgram {
 protected:
  nlohmann::json fit(const std::string& folder) const {
    return json(folder + "/report.json")["fit"];
  }

  Outcome match_with_landmark(int source, int target, const std::vector<std::string>& more = {}) {
    folder_.write("landmarks.txt",
                  std::to_string(source) + " " + std::to_string(target + kExtraVertices) + "\n");
    std::vector<std::string> options{"--landmarks", path("landmarks.txt")};
    options.insert(options.end(), more.begin(), more.end());
    return run(arguments("out", options));
  }
};

TEST_F(Verdict, ARightMapIsGood) {
  const Outcome outcome = run(arguments("out"));
  EXPECT_THAT(outcome.output, HasSubstr("fit: good (distances between neighbours change by"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("fit: doubtful")));
  EXPECT_EQ(fit("out")["grade"], "good");
  EXPECT_TRUE(fit("out")["reasons"].empty());
  for (const char* measure :
       {"stretch", "distorted", "displacement", "relief", "unreached", "unmatched", "reversed"})
    EXPECT_TRUE(fit("out")[measure].is_number()) << measure;
}

TEST_F(Verdict, AMapBetweenDifferentThingsIsPoorAndSaidSoWithQuiet) {
  Mesh stretched = target_;
  for (Point& p : stretched.vertices) p[0] *= 8;
  write_mesh(path("target.ply"), stretched);
  const Outcome outcome = run(arguments("out", {"--quiet"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.output, "");
  EXPECT_THAT(outcome.errors, HasSubstr("warning: poor fit: "));
  EXPECT_EQ(fit("out")["grade"], "poor");
  EXPECT_THAT(run(arguments("out")).output, HasSubstr("\n! poor fit: "));
}

TEST_F(Verdict, AGraveDefectMakesAGoodFitDoubtful) {
  Mesh spiked = source_;
  spiked.vertices[7] *= 1000;
  write_mesh(path("source.off"), spiked);
  EXPECT_THAT(run(arguments("out")).output, HasSubstr("the source has a grave defect"));
  EXPECT_EQ(fit("out")["grade"], "doubtful");
}

TEST_F(Verdict, ThePaperMethodIsJudgedToo) {
  const Outcome outcome = run(arguments("out", {"--method", "paper"}));
  EXPECT_THAT(outcome.output, HasSubstr("\nfit: "));
  EXPECT_TRUE(fit("out")["reversed"].is_number());
}

TEST_F(Verdict, AlternativesAreJudgedBesideTheBestMap) {
  ASSERT_EQ(run(arguments("out", {"--alternatives", "2"})).exit_code, 0);
  const nlohmann::json report = json("out/report.json");
  ASSERT_FALSE(report["alternatives"].empty());
  for (const nlohmann::json& alternative : report["alternatives"])
    EXPECT_NE(alternative["fit"]["grade"], "good");
}

TEST_F(Verdict, ATrueLandmarkDoesNotMakeTheMapWorse) {
  ASSERT_EQ(run(arguments("free")).exit_code, 0);
  const double energy = json("free/report.json")["map"]["energy"];
  const std::vector<int> source = creature(1).ground_truth, target = creature(2).ground_truth;
  for (std::size_t point : {700, 4100}) {
    ASSERT_EQ(match_with_landmark(source[point], target[point]).exit_code, 0);
    EXPECT_LT(json("out/report.json")["map"]["energy"], 1.3 * energy) << point;
    EXPECT_TRUE(json("out/report.json")["contradicted_landmarks"].empty()) << point;
  }
}

TEST_F(Verdict, ALandmarkThatContradictsTheShapesIsNamed) {
  const int source = ends_of(creature(1)).front, target = ends_of(creature(2)).behind;
  const std::string name = std::to_string(source) + " " + std::to_string(target + kExtraVertices);
  EXPECT_THAT(match_with_landmark(source, target, {"--quiet"}).errors,
              HasSubstr("the landmark " + name + " contradicts the shapes"));
  const nlohmann::json report = json("out/report.json");
  EXPECT_EQ(report["contradicted_landmarks"],
            nlohmann::json::array({{source, target + kExtraVertices}}));
  EXPECT_NE(report["fit"]["grade"], "good");
}

}  // namespace
}  // namespace isomatch::test
