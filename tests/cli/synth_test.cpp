// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/synth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "program.h"
#include "support/temporary_folder.h"

namespace isomatch::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Synth : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  /// Checks that `arguments` are rejected with one line and without a file; returns the line.
  std::string rejection(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "synth");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
    EXPECT_TRUE(folder_.names().empty());
    return outcome.errors;
  }

  TemporaryFolder folder_;
};

TEST_F(Synth, WritesTheMeshAndBothTruthsBesideIt) {
  const Outcome outcome = run({"synth", "--shape", "creature", "--vertices", "1000", "--pose", "2",
                               "--seed", "3", "-o", path("made.ply")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(folder_.names(), ElementsAre("made.ply", "made.sym.vts", "made.vts"));

  const SynthShape expected = synthesize({"creature", 1000, 2, 3});
  const Mesh mesh = read_mesh(path("made.ply"));
  EXPECT_EQ(mesh.vertices, expected.mesh.vertices);
  EXPECT_EQ(mesh.faces, expected.mesh.faces);
  EXPECT_EQ(read_ground_truth(path("made.vts"), mesh.num_vertices()), expected.ground_truth);
  EXPECT_EQ(read_ground_truth(path("made.sym.vts"), mesh.num_vertices()),
            expected.symmetric_ground_truth);
}

TEST_F(Synth, PartsHaveZerosInTheirTruths) {
  const Outcome outcome = run({"synth", "--vertices", "1000", "--pose", "2", "--cut", ".4",
                               "--holes", "1", "-o", path("part.off")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;

  const SynthShape expected = synthesize({.vertices = 1000, .pose = 2, .cut = 0.4, .holes = 1});
  const int vertices = read_mesh(path("part.off")).num_vertices();
  EXPECT_EQ(vertices, expected.mesh.num_vertices());
  EXPECT_EQ(read_ground_truth(path("part.vts"), vertices), expected.ground_truth);
  EXPECT_EQ(read_ground_truth(path("part.sym.vts"), vertices), expected.symmetric_ground_truth);
}

TEST_F(Synth, BadArgumentsAreNamed) {
  EXPECT_THAT(rejection({"--shape", "teapot", "-o", path("a.off")}), HasSubstr("'teapot'"));
  EXPECT_THAT(rejection({"--vertices", "3", "-o", path("a.off")}), HasSubstr("not 3"));
  EXPECT_THAT(rejection({"--vertices", "many", "-o", path("a.off")}), HasSubstr("many"));
  EXPECT_THAT(rejection({"--pose", "-1", "-o", path("a.off")}), HasSubstr("not -1"));
  EXPECT_THAT(rejection({"--cut", "1.5", "-o", path("a.off")}), HasSubstr("not 1.5"));
  EXPECT_THAT(rejection({"--holes", "-2", "-o", path("a.off")}), HasSubstr("not -2"));
  EXPECT_THAT(rejection({"--vertices", "1000", "--holes", "500", "-o", path("a.off")}),
              HasSubstr("room for"));
  EXPECT_THAT(rejection({}), HasSubstr("--output"));
}

TEST_F(Synth, OutputThatCannotBeWrittenIsRejectedBeforeTheWork) {
  const std::vector<std::string> large = {"--vertices", "4000000", "-o"};
  const auto start = std::chrono::steady_clock::now();
  for (const std::string& name : {path("a.txt"), std::string("/proc/missing/a.off")})
    EXPECT_THAT(rejection({large[0], large[1], large[2], name}), StartsWith("isomatch: " + name));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

}  // namespace
}  // namespace isomatch::test
