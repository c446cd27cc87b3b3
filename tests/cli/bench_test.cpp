// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/mesh/synth.h"
#include "program.h"
#include "support/temporary_folder.h"

namespace isomatch::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A creature in two poses, with both truths.
class Bench : public testing::Test {
 protected:
  void SetUp() override {
    write("source", 1);
    write("target", 2);
  }

  void write(const std::string& name, int pose) const {
    const SynthShape shape = synthesize({.vertices = 1000, .pose = pose, .seed = 2});
    write_mesh(path(name + ".off"), shape.mesh);
    write_map(path(name + ".vts"), {.source_to_target = shape.ground_truth});
    write_map(path(name + ".sym.vts"), {.source_to_target = shape.symmetric_ground_truth});
  }

  std::string path(const std::string& name) const { return folder_.path(name); }

  Outcome run_bench(const std::vector<std::string>& more) const {
    std::vector<std::string> all{path("source.off"), path("target.off")};
    all.insert(all.end(), more.begin(), more.end());
    return run(all, {.program = bench_program()});
  }

  nlohmann::json report(const std::vector<std::string>& more) const {
    const Outcome outcome = run_bench(more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output);
  }

  std::vector<std::string> with_truth(const std::string& methods) const {
    return {"--methods",       methods,
            "--gt-source",     path("source.vts"),
            "--gt-target",     path("target.vts"),
            "--gt-target-sym", path("target.sym.vts")};
  }

  TemporaryFolder folder_;
};

TEST_F(Bench, MeasuresEveryMethod) {
  const nlohmann::json all = report(with_truth("paper,tracked,spectral,gmds,zoomout"));
  for (const char* name : {"paper", "tracked", "spectral", "gmds", "zoomout"}) {
    const nlohmann::json& method = all["methods"][name];
    EXPECT_GE(method["seconds"], method["preparation_seconds"]) << name;
    EXPECT_GE(method["peak_memory_mib"], method["loaded_memory_mib"]) << name;
    const nlohmann::json& map = method["maps"]["final"];
    EXPECT_LT(map["d_iso_over_max_geodesic"]["mean"], 0.1) << name;
    const double direct = map["ground_truth"]["error_over_sqrt_area"]["mean"];
    const double mirrored = map["symmetric_ground_truth"]["error_over_sqrt_area"]["mean"];
    EXPECT_LT(std::min(direct, mirrored), 0.2) << name;
    EXPECT_EQ(map["flipped"], mirrored < direct) << name;
    const nlohmann::json& curve = map["ground_truth"]["cumulative"];
    EXPECT_EQ(curve.size(), 51) << name;
    EXPECT_TRUE(std::is_sorted(curve.begin(), curve.end())) << name;
  }
  EXPECT_EQ(all["source"]["file"], path("source.off"));
  EXPECT_FALSE(all["methods"]["paper"]["levels"].empty());
  EXPECT_TRUE(all["methods"]["tracked"]["maps"]["final"]["ground_truth"].contains(
      "point_error_over_sqrt_area"));
}

TEST_F(Bench, NeedsNoTruth) {
  const nlohmann::json map =
      report({"--methods", "spectral"})["methods"]["spectral"]["maps"]["final"];
  EXPECT_GT(map["d_iso_over_max_geodesic"]["mean"], 0);
  EXPECT_FALSE(map.contains("ground_truth"));
}

TEST_F(Bench, MeasuresOtherMapsOnRequest) {
  const nlohmann::json methods =
      report({"--methods", "paper,spectral", "--maps", "bases,level2_many_to_one"})["methods"];
  EXPECT_TRUE(methods["paper"]["maps"].contains("level2_many_to_one"));
  EXPECT_TRUE(methods["spectral"]["maps"].contains("bases"));
  EXPECT_FALSE(methods["paper"]["maps"].contains("final"));
}

TEST_F(Bench, WritesReportAndMaps) {
  std::filesystem::create_directory(path("maps"));
  const Outcome outcome = run_bench(
      {"--methods", "tracked,spectral", "-o", path("report.json"), "--write-maps", path("maps")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
  EXPECT_TRUE(nlohmann::json::parse(read_file(path("report.json"))).contains("methods"));
  const int source = read_mesh(path("source.off")).num_vertices();
  const Mesh target = read_mesh(path("target.off"));
  const MapChecks counts{source, target.num_vertices(), target.num_faces()};
  EXPECT_EQ(std::ssize(read_map(path("maps/spectral.txt"), counts).source_to_target), source);
  EXPECT_EQ(std::ssize(read_map(path("maps/tracked.txt"), counts).source_to_target), source);
  EXPECT_EQ(std::ssize(read_map(path("maps/tracked.bary.txt"), counts).points), source);
}

TEST_F(Bench, OneMethodsFailureIsNoOthers) {
  // Too few vertices for the eigenfunctions of zoomout.
  const Mesh small = synthesize({.vertices = 1000, .pose = 1, .seed = 2}).mesh;
  Mesh part{small.vertices, {}};
  part.faces.assign(small.faces.begin(), small.faces.begin() + 1);
  write_mesh(path("source.off"), part);
  const nlohmann::json methods = report({"--methods", "zoomout,spectral"})["methods"];
  EXPECT_THAT(std::string(methods["zoomout"]["failure"]), HasSubstr("zoomout needs surfaces"));
  EXPECT_TRUE(methods.contains("spectral"));
}

TEST_F(Bench, UnknownMethodIsNamed) {
  const Outcome outcome = run_bench({"--methods", "magic"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, StartsWith("isomatch-bench: there is no method 'magic'"));
}

TEST_F(Bench, BadFilesAreNamed) {
  folder_.write("bad.off", "OFF\n1\n");
  const Outcome mesh = run({path("bad.off"), path("target.off")}, {.program = bench_program()});
  EXPECT_EQ(mesh.exit_code, 2);
  EXPECT_THAT(mesh.errors, StartsWith("isomatch-bench: " + path("bad.off") + ": "));
  folder_.write("target.vts", "-1\n");
  const Outcome truth = run_bench(with_truth("spectral"));
  EXPECT_EQ(truth.exit_code, 2);
  EXPECT_THAT(truth.errors, StartsWith("isomatch-bench: " + path("target.vts") + ": line 1: "));
}

TEST_F(Bench, OutputIsCheckedBeforeTheWork) {
  const Outcome report = run_bench({"-o", path("absent/report.json")});
  EXPECT_EQ(report.exit_code, 2);
  EXPECT_THAT(report.errors, HasSubstr("absent"));
  const Outcome maps = run_bench({"--write-maps", path("absent")});
  EXPECT_EQ(maps.exit_code, 2);
  EXPECT_THAT(maps.errors, StartsWith("isomatch-bench: " + path("absent") + ": is not a folder"));
}

TEST_F(Bench, Interrupted) {
  const Outcome outcome =
      run({path("source.off"), path("target.off"), "--methods", "gmds,gmds,gmds,gmds,gmds"},
          {.program = bench_program(), .interrupt_after = std::chrono::milliseconds(300)});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.errors, "isomatch-bench: interrupted\n");
}

}  // namespace
}  // namespace isomatch::test
