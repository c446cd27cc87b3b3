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

/// Endings of outputs, and the folders above them.
class OutputNames : public MatchProgram {
 protected:
  void SetUp() override {
    MatchProgram::SetUp();
    std::string labels;
    for (int v = 0; v < source_.num_vertices(); ++v) labels += "1\n";
    folder_.write("labels.txt", labels);
    ASSERT_EQ(run(arguments("out", {"--no-elastic-judging", "--no-refinement"})).exit_code, 0);
  }

  /// The message of a command that must fail and leave nothing named `output`.
  std::string refusal(std::vector<std::string> command, const std::string& output) const {
    command.push_back(path(output));
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 2) << output;
    EXPECT_FALSE(fs::exists(path(output)));
    return outcome.errors;
  }

  std::vector<std::string> match() const {
    return {"match", path("source.off"), path("target.ply"), "-o"};
  }
  std::vector<std::string> render() const {
    return {"render", path("out"), "--width", "200", "-o"};
  }
  std::vector<std::string> convert() const { return {"convert", path("out")}; }
  std::vector<std::string> transfer(const std::string& what, const std::string& file) const {
    return {"transfer", path("out"), what, path(file), "-o"};
  }
};

TEST_F(OutputNames, PromiseWhatIsWritten) {
  EXPECT_THAT(refusal(render(), "x.jpg"), HasSubstr("must be named .png"));
  EXPECT_THAT(refusal(match(), "x.ply"), HasSubstr("a folder is written here"));
  EXPECT_THAT(refusal(convert(), "x.stl"), HasSubstr("write .off, .obj, .ply, .glb"));
  EXPECT_THAT(refusal(convert(), "x.blend"), HasSubstr(".off .obj .ply .glb .gltf .mat"));
  EXPECT_THAT(refusal({"synth", "-o"}, "x.png"), HasSubstr(".off .obj .ply"));
  EXPECT_THAT(refusal(transfer("--labels", "labels.txt"), "x.npz"), HasSubstr(".txt or .csv"));
  EXPECT_THAT(refusal(transfer("--values", "labels.txt"), "x.ply"), HasSubstr(".txt or .csv"));
  EXPECT_THAT(refusal(transfer("--skin", "labels.txt"), "x.csv"), HasSubstr("name it .txt"));
  EXPECT_THAT(refusal(transfer("--landmarks", "labels.txt"), "x.csv"), HasSubstr(".bary.txt"));
  EXPECT_THAT(refusal(transfer("--poses", "source.off"), "x.ply"), HasSubstr("a folder"));
}

TEST_F(OutputNames, FoldersAboveThemAreMade) {
  for (auto [command, output] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {match(), "made/by/match"},
           {render(), "made/by/render/x.png"},
           {convert(), "made/by/convert/x.glb"},
           {{"synth", "--vertices", "1000", "-o"}, "made/by/synth/x.off"},
           {transfer("--labels", "labels.txt"), "made/by/transfer/x.txt"},
           {transfer("--poses", "source.off"), "made/by/transfer/poses"}}) {
    command.push_back(path(output));
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_TRUE(fs::exists(path(output)));
  }
}

TEST_F(OutputNames, FoldersOfWhatIsNotWrittenAreNotLeft) {
  fs::create_directory(path("mine"));
  folder_.write("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  folder_.write("short.txt", "1\n");
  for (const auto& [command, output] :
       std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"match", path("source.off"), path("flat.off"), "-o"}, "mine/new/match"},
           {{"match", path("source.off"), path("flat.off"), "-o"}, "mine/new/match/"},
           {{"render", path("absent"), "-o"}, "mine/new/x.png"},
           {{"convert", path("absent.off")}, "mine/new/x.off"},
           {{"synth", "--vertices", "1", "-o"}, "mine/new/x.off"},
           {transfer("--labels", "short.txt"), "mine/new/x.txt"}}) {
    refusal(command, output);
    EXPECT_FALSE(fs::exists(path("mine/new"))) << output;
    EXPECT_TRUE(fs::exists(path("mine"))) << output;
  }
  EXPECT_THAT(refusal(render(), "labels.txt/deep/x.png"), HasSubstr("cannot be created"));
}

}  // namespace
}  // namespace isomatch::test
