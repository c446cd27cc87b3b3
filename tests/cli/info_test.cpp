// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "isomatch/io/mesh_io.h"
#include "program.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch::test {
namespace {

using testing::HasSubstr;

class Info : public testing::Test {
 protected:
  std::string write(const std::string& name, const Mesh& mesh) const {
    write_mesh(folder_.path(name), mesh);
    return folder_.path(name);
  }

  /// Checks that `info` rejects a file of `content` and returns the reason.
  std::string rejection(const std::string& name, std::string_view content) const {
    const std::string path = folder_.write(name, content);
    const Outcome outcome = run({"info", path});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.output, "");
    const std::string prefix = "isomatch: " + path + ": ";
    EXPECT_THAT(outcome.errors, testing::StartsWith(prefix));
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
    return outcome.errors.substr(std::min(prefix.size(), outcome.errors.size()));
  }

  TemporaryFolder folder_;
};

TEST_F(Info, DescribesSoundMeshWithoutWarnings) {
  const Outcome outcome = run({"info", write("sphere.off", icosphere(2))});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, testing::ContainsRegex("vertices +162\n"));
  EXPECT_THAT(outcome.output, testing::ContainsRegex("genus +0\n"));
  EXPECT_THAT(outcome.output, testing::Not(HasSubstr("!")));
  EXPECT_EQ(outcome.errors, "");
}

TEST_F(Info, WarnsOfDefects) {
  const Outcome outcome = run({"info", write("holed.ply", sphere_with_hole())});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("\n! 1 hole"));
}

TEST_F(Info, WhatTheReaderLeftOutIsAWarningOnStandardError) {
  const std::string path =
      folder_.write("short.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n");
  const Outcome outcome = run({"info", "--json", path});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors,
            "warning: " + path + ": faces of fewer than three corners, left out: 1\n");
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["read_warnings"].size(), 1U);
}

TEST_F(Info, PrintsJson) {
  const Outcome outcome = run({"info", "--json", write("torus.obj", torus(12, 8))});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["vertices"], 96);
  EXPECT_EQ(json["surface"]["genus"], 1);
  EXPECT_EQ(json["surface"]["boundary_loops"], 0);
  EXPECT_TRUE(json["warnings"].empty());
}

TEST_F(Info, WhatHasNoGenusIsNullInJson) {
  const Outcome outcome = run({"info", "--json", write("strip.off", moebius_strip(30))});
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_TRUE(json["surface"]["genus"].is_null());
  EXPECT_FALSE(json["warnings"].empty());
}

TEST_F(Info, NamesFilePlaceAndReason) {
  EXPECT_THAT(rejection("empty.off", ""), HasSubstr("empty"));
  EXPECT_THAT(rejection("short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n"), HasSubstr("line"));
  EXPECT_THAT(rejection("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
              HasSubstr("line 6"));
  EXPECT_THAT(rejection("large.obj", "v 0 0 0\nv 1 1e200 0\nv 0 1 0\nf 1 2 3\n"),
              HasSubstr("vertex 1"));
  EXPECT_THAT(rejection("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), HasSubstr("face"));
  rejection("mesh.xyz", "0 0 0\n");
  rejection("mesh.ply", "ply\nformat ascii 1.0\nend_header\n");
  rejection("mesh.stl", "solid\n");
}

TEST_F(Info, MissingFileAndFolderAreBadInput) {
  for (const std::string& path : {folder_.path("absent.off"), folder_.path("")}) {
    const Outcome outcome = run({"info", path});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.errors, testing::StartsWith("isomatch: " + path + ": "));
  }
}

}  // namespace
}  // namespace isomatch::test
