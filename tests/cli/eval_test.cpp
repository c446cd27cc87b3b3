// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "program.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"
#include "support/transforms.h"

namespace isomatch::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A rough sphere, its mirror image, and maps between them that keep vertex numbers.
class Eval : public testing::Test {
 protected:
  void SetUp() override {
    write_mesh(path("source.off"), mesh_);
    write_mesh(path("target.off"), mirrored(mesh_));
    write_map(path("map.txt"), {.source_to_target = numbers_});
    write_map(path("source.vts"), {.source_to_target = numbers_});
    write_map(path("target.vts"), {.source_to_target = numbers_});
    std::vector<int> other = numbers_;
    std::rotate(other.begin(), other.begin() + 1, other.end());
    write_map(path("target.sym.vts"), {.source_to_target = other});
  }

  std::string path(const std::string& name) const { return folder_.path(name); }

  std::vector<std::string> arguments(const std::vector<std::string>& more = {},
                                     const std::string& map = "map.txt") const {
    std::vector<std::string> all{"eval", path("source.off"), path("target.off"), path(map)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  std::vector<std::string> truth() const {
    return {"--gt-source", path("source.vts"), "--gt-target", path("target.vts")};
  }

  nlohmann::json json(std::vector<std::string> more, const std::string& map = "map.txt") const {
    more.push_back("--json");
    const Outcome outcome = run(arguments(more, map));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output);
  }

  const Mesh mesh_ = rough_sphere(2, 0.1, 1);
  const std::vector<int> numbers_ = [this] {
    std::vector<int> all(mesh_.num_vertices());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }();
  TemporaryFolder folder_;
};

TEST_F(Eval, NeedsNoTruth) {
  const nlohmann::json result = json({});
  EXPECT_EQ(result["matches"], mesh_.num_vertices());
  // Distances differ by the error of the visibility graph, .2 %.
  EXPECT_LT(result["d_iso_over_max_geodesic"]["mean"], 0.002);
  EXPECT_EQ(result["target_hit"]["vertices"], 1);
  EXPECT_EQ(result["orientation"]["verdict"], "reverses");
  EXPECT_FALSE(result.contains("ground_truth"));
}

TEST_F(Eval, RightMapHasNoError) {
  const nlohmann::json result = json(truth());
  EXPECT_EQ(result["ground_truth"]["template_points"], mesh_.num_vertices());
  EXPECT_EQ(result["ground_truth"]["error_over_sqrt_area"]["maximum"], 0);
  EXPECT_EQ(result["ground_truth"]["d_grd_over_max_geodesic"]["mean"], 0);
  EXPECT_FALSE(result.contains("flipped"));
}

TEST_F(Eval, ComparesWithSymmetricTruth) {
  std::vector<std::string> more = truth();
  more.insert(more.end(), {"--gt-target-sym", path("target.sym.vts")});
  EXPECT_EQ(json(more)["flipped"], false);
  more[3] = path("target.sym.vts");
  more[5] = path("target.vts");
  const nlohmann::json flipped = json(more);
  EXPECT_EQ(flipped["flipped"], true);
  EXPECT_GT(flipped["ground_truth"]["error_over_sqrt_area"]["mean"], 0);
  EXPECT_EQ(flipped["symmetric_ground_truth"]["error_over_sqrt_area"]["mean"], 0);
}

TEST_F(Eval, MapMayBeNumberedFromOneOrListPairs) {
  write_map(path("one_based.txt"), {.source_to_target = numbers_}, Numbering::kFromOne);
  write_correspondence(path("pairs.txt"), to_correspondence(numbers_));
  nlohmann::json plain = json(truth());
  EXPECT_EQ(plain["map_numbered_from"], 0);
  EXPECT_EQ(json(truth(), "pairs.txt"), plain);
  plain["map_numbered_from"] = 1;
  std::vector<std::string> one_based = truth();
  one_based.push_back("--one-based");
  EXPECT_EQ(json(one_based, "one_based.txt"), plain);
}

TEST_F(Eval, NumberingFollowsTheEndingAsEverywhere) {
  const MapContent map{numbers_, {}};
  std::string floats = "# made by numpy\n";
  for (int v : numbers_) floats += fmt::format("{:.18e}\n", static_cast<double>(v));
  folder_.write("floats.txt", floats);
  write_map(path("map.vts"), map);
  write_map(path("map.VTS"), map);
  write_map(path("map.npz"), map);
  write_map(path("ones.map"), map, Numbering::kFromOne);
  for (const char* name : {"map.vts", "map.VTS", "map.npz", "ones.map", "floats.txt"}) {
    const nlohmann::json result = json(truth(), name);
    EXPECT_EQ(result["ground_truth"]["error_over_sqrt_area"]["maximum"], 0) << name;
    EXPECT_EQ(result["matches"], mesh_.num_vertices()) << name;
  }
  EXPECT_THAT(run(arguments({}, "ones.map")).output, HasSubstr("numbered from one, since"));
  write_map(path("source.txt"), map);
  EXPECT_EQ(json({"--gt-source", path("source.txt"), "--gt-target",
                  path("map.npz")})["ground_truth"]["error_over_sqrt_area"]["maximum"],
            0);
}

TEST_F(Eval, NumberingThatIsAssumedIsTold) {
  std::string pairs;
  for (int v = 1; v < mesh_.num_vertices(); ++v) pairs += fmt::format("{} {}\n", v, v);
  folder_.write("pairs.txt", pairs);
  EXPECT_THAT(run(arguments({}, "pairs.txt")).output, HasSubstr("taken as numbered from zero"));
  EXPECT_EQ(run(arguments({}, "map.txt")).output.find("numbered"), std::string::npos);
}

TEST_F(Eval, PointsOnTrianglesHaveAnErrorOfTheirOwn) {
  const Mesh target = mirrored(mesh_);
  // A third of the way to the next corner, along an edge of the first face at each vertex.
  SurfaceMap map(mesh_.vertices.size());
  double sum = 0;
  for (int f = target.num_faces() - 1; f >= 0; --f) {
    for (int k = 0; k < 3; ++k) {
      SurfacePoint& point = map[target.faces[f][k]];
      point = {f, {}};
      point.weights[k] = 2.0 / 3;
      point.weights[(k + 1) % 3] = 1 - 2.0 / 3;
    }
  }
  for (int v = 0; v < mesh_.num_vertices(); ++v)
    sum += (position(target, map[v]) - target.vertices[v]).norm();
  write_map(path("map.bary.txt"), {.points = map});
  const nlohmann::json result = json(truth(), "map.bary.txt");
  EXPECT_EQ(result["ground_truth"]["error_over_sqrt_area"]["maximum"], 0);
  // Edges carry their exact length, up to rounding to float.
  EXPECT_NEAR(result["ground_truth"]["point_error_over_sqrt_area"]["mean"],
              sum / mesh_.num_vertices() / std::sqrt(surface_area(mesh_)), 1e-5);
  EXPECT_FALSE(json(truth())["ground_truth"].contains("point_error_over_sqrt_area"));
  EXPECT_THAT(run(arguments(truth(), "map.bary.txt")).output, HasSubstr("points on triangles"));
}

TEST_F(Eval, BadPointIsNamedWithLine) {
  folder_.write("bad.bary.txt", "0 1 0 0\n0 1 1 0\n");
  const Outcome outcome = run(arguments({}, "bad.bary.txt"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, StartsWith("isomatch: " + path("bad.bary.txt") + ": line 2: "));
}

TEST_F(Eval, ThreadsChangeNothing) {
  std::vector<std::string> one = truth(), three = truth();
  one.insert(one.end(), {"--threads", "1"});
  three.insert(three.end(), {"--threads", "3"});
  EXPECT_EQ(json(one), json(three));
}

TEST_F(Eval, NamesNormalisations) {
  const Outcome outcome = run(arguments(truth()));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("sqrt(area of target)"));
  EXPECT_THAT(outcome.output, HasSubstr("D_grd / maximum geodesic"));
  EXPECT_THAT(outcome.output, HasSubstr("D_iso / maximum geodesic"));
}

TEST_F(Eval, ProgressIsShownOnTerminalOnly) {
  EXPECT_EQ(run(arguments()).errors, "");
  EXPECT_THAT(run(arguments(), {.terminal = true}).errors, HasSubstr("% distortion"));
  EXPECT_EQ(run(arguments({"--quiet"}), {.terminal = true}).errors, "");
}

TEST_F(Eval, BadMapIsNamedWithLine) {
  folder_.write("bad.txt", "0\n1\nx\n");
  const Outcome outcome = run(arguments({}, "bad.txt"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, StartsWith("isomatch: " + path("bad.txt") + ": line 3: "));
}

TEST_F(Eval, MapOfOtherMeshIsRejected) {
  folder_.write("short.txt", "0\n1\n2\n");
  const Outcome outcome = run(arguments({}, "short.txt"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("is for 3 vertices, but the source has 162"));
}

TEST_F(Eval, TruthsOfDifferentLengthAreRejected) {
  folder_.write("short.vts", "1\n2\n");
  const Outcome outcome =
      run(arguments({"--gt-source", path("source.vts"), "--gt-target", path("short.vts")}));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, StartsWith("isomatch: " + path("short.vts") + ": "));
}

TEST_F(Eval, FlatMeshIsNamed) {
  folder_.write("source.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  const Outcome outcome = run(arguments());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, StartsWith("isomatch: " + path("source.off") + ": "));
}

TEST_F(Eval, LeavesNoFilesBehind) {
  const std::vector<std::string> before = folder_.names();
  run(arguments(truth()));
  run(arguments({}, "absent.txt"));
  EXPECT_EQ(folder_.names(), before);
}

}  // namespace
}  // namespace isomatch::test
