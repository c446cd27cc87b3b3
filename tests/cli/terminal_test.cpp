// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>

#include <sstream>

#include "match_program.h"
#include "program.h"

namespace isomatch::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What is to be read on a terminal in the end: each line behind the last time it was cleared.
std::string visible(const std::string& written) {
  std::istringstream lines(written);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t cleared = line.rfind("\r\x1b[K");
    text += (cleared == std::string::npos ? line : line.substr(cleared + 4)) + "\n";
  }
  return text;
}

class Terminal : public MatchProgram {
 protected:
  static std::string written(const std::vector<std::string>& arguments) {
    const Outcome outcome = run(arguments, {.all_on_terminal = true});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    return outcome.output;
  }
};

TEST_F(Terminal, NoProgressStandsBeforeWhatIsPrinted) {
  for (const char* method : {"tracked", "paper"}) {
    const std::string all = written(arguments("out", {"--method", method}));
    EXPECT_THAT(all, HasSubstr("% "));
    EXPECT_THAT(visible(all), Not(HasSubstr("[#")));
    EXPECT_THAT(visible(all), HasSubstr("written to " + path("out")));
  }
  const std::string eval =
      written({"eval", path("source.off"), path("target.ply"), path("out/source_to_target.txt")});
  EXPECT_THAT(visible(eval), Not(HasSubstr("[#")));
}

TEST_F(Terminal, NoProgressStandsBeforeErrors) {
  folder_.write("landmarks.txt", "0 99999\n");
  const Outcome outcome =
      run(arguments("out", {"--landmarks", path("landmarks.txt")}), {.all_on_terminal = true});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(visible(outcome.output), testing::StartsWith("isomatch: "));
}

TEST_F(Terminal, EveryStageIsShown) {
  const std::string all = written(arguments("out"));
  for (const char* stage : {"% reading", "% shapes", "% hypotheses", "% refinement", "% writing"})
    EXPECT_THAT(all, HasSubstr(stage));
}

TEST_F(Terminal, QuietHidesTheSummaryAndNotWarnings) {
  Mesh turned = source_;
  Random random(1);
  for (Face& face : turned.faces)
    if (random.uniform() < 0.5) std::swap(face[0], face[1]);
  write_mesh(path("source.off"), turned);
  const Outcome outcome = run(arguments("out", {"--quiet"}), {.terminal = true});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
  EXPECT_THAT(outcome.errors, HasSubstr("warning: a surface does not tell outside from inside"));
  EXPECT_THAT(outcome.errors, HasSubstr("target.ply: 2 components"));
  EXPECT_THAT(outcome.errors, Not(HasSubstr("[#")));
}

TEST_F(Terminal, CommandsSayWhatTheyWrote) {
  ASSERT_EQ(run(arguments("out")).exit_code, 0);
  folder_.write("landmarks.txt", "5\n");
  const std::string out = path("out"), picture = path("picture.png"), model = path("model.glb"),
                    carried = path("carried.txt"), shape = path("shape.off");
  for (const auto& [command, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"transfer", out, "--landmarks", path("landmarks.txt"), "-o", carried},
            "landmarks written to " + carried + "\n"},
           {{"convert", out, model}, "written to " + model + "\n"},
           {{"render", out, "-o", picture, "--width", "200"}, "written to " + picture + "\n"},
           {{"synth", "--vertices", "1000", "-o", shape}, "written to " + shape}}) {
    const Outcome loud = run(command);
    EXPECT_THAT(loud.output, HasSubstr(said));
    EXPECT_EQ(std::ranges::count(loud.output, '\n'), 1) << loud.output;
    std::vector<std::string> quiet = command;
    quiet.emplace_back("--quiet");
    EXPECT_EQ(run(quiet).output, "");
  }
}

}  // namespace
}  // namespace isomatch::test
