// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/maps/surface_map.h"
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

/// The map and the truth leave different parts of the sphere out.
class EvalPartial : public Eval {
 protected:
  /// The identity without the vertices from `first` to before `last`.
  VertexMap without(int first, int last) const {
    VertexMap map = numbers_;
    std::fill(map.begin() + first, map.begin() + last, kUnmatched);
    return map;
  }

  /// In all forms.
  void write(const std::string& stem, const VertexMap& map) const {
    const SurfaceMap points = corner_points(target_, map);
    write_map(path(stem + ".txt"), {.source_to_target = map});
    write_map(path(stem + ".map"), {.source_to_target = map});
    write_map(path(stem + ".bary.txt"), {.points = points});
    write_map(path(stem + ".npz"), {map, points});
    write_map(path(stem + ".vertices.npz"), {.source_to_target = map});
    write_map(path(stem + ".points.npz"), {.points = points});
    folder_.write(stem + ".vts", vts(map));
  }

  static std::string vts(const VertexMap& map) {
    std::string lines;
    for (const int v : map) lines += fmt::format("{}\n", v + 1);
    return lines;
  }

  double area(int first, int last) const {
    double sum = 0;
    for (const Face& face : mesh_.faces) {
      const Point& a = mesh_.vertices[face[0]];
      for (const int v : face)
        if (v >= first && v < last)
          sum += (mesh_.vertices[face[1]] - a).cross(mesh_.vertices[face[2]] - a).norm() / 6;
    }
    return sum / surface_area(mesh_);
  }

  nlohmann::json against(const std::string& truth, const std::string& map) const {
    return json({"--gt-map", path(truth)}, map)["ground_truth_map"];
  }

  void expect_refused(const std::string& name, const std::string& content,
                      const std::string& reason) const {
    folder_.write(name, content);
    const Outcome outcome = run(arguments({"--gt-map", path(name)}));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.errors, StartsWith("isomatch: " + path(name) + ": "));
    EXPECT_THAT(outcome.errors, HasSubstr(reason));
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << outcome.errors;
  }

  const Mesh target_ = mirrored(mesh_);
  const std::vector<std::string> forms_{".txt",          ".map",        ".bary.txt", ".npz",
                                        ".vertices.npz", ".points.npz", ".vts"};
};

TEST_F(EvalPartial, EveryFormOfMapAndTruthGivesTheSameFigures) {
  write("part", without(0, 60));
  write("truth", without(40, 100));
  const double both = area(100, 162), either = area(0, 40) + area(60, 100) + both;
  for (const std::string& map : forms_) {
    for (const std::string& truth : {std::string(".npz"), map}) {
      const nlohmann::json result = against("truth" + truth, "part" + map);
      const nlohmann::json& overlap = result["overlap"];
      EXPECT_NEAR(overlap["iou"], both / either, 1e-6) << map << truth;
      EXPECT_NEAR(overlap["unmatched_precision"], area(40, 60) / area(0, 60), 1e-6);
      EXPECT_NEAR(overlap["unmatched_recall"], area(40, 60) / area(40, 100), 1e-6);
      EXPECT_NEAR(overlap["matched_share"], area(60, 162), 1e-6);
      EXPECT_NEAR(overlap["truly_matched_share"], 1 - area(40, 100), 1e-6);
      EXPECT_EQ(result["error_over_sqrt_area"]["samples"], 62);
      EXPECT_EQ(result["error_over_sqrt_area"]["maximum"], 0);
      EXPECT_EQ(result["d_grd_over_max_geodesic"]["maximum"], 0);
    }
  }
  for (const std::string& truth : forms_)
    EXPECT_NEAR(against("truth" + truth, "part.txt")["overlap"]["iou"], both / either, 1e-6);
}

TEST_F(EvalPartial, TruthOnTrianglesIsExact) {
  SurfaceMap points = corner_points(target_, without(40, 100));
  for (SurfacePoint& point : points)
    if (point.face >= 0) point.weights = {0.5, 0.25, 0.25};
  write_map(path("truth.bary.txt"), {.points = points});
  const nlohmann::json result = against("truth.bary.txt", "truth.bary.txt");
  EXPECT_EQ(result["point_error_over_sqrt_area"]["maximum"], 0);
  EXPECT_EQ(result["point_d_grd_over_max_geodesic"]["maximum"], 0);
  EXPECT_GT(result["error_over_sqrt_area"]["mean"], 0);
  double sum = 0;
  for (const SurfacePoint& point : points)
    if (point.face >= 0)
      sum += (position(target_, point) - target_.vertices[target_.faces[point.face][0]]).norm();
  EXPECT_NEAR(result["error_over_sqrt_area"]["mean"], sum / 102 / std::sqrt(surface_area(mesh_)),
              1e-5);
}

TEST_F(EvalPartial, TextNamesWhatIsCounted) {
  write("part", without(0, 60));
  write("truth", without(40, 100));
  const std::string output = run(arguments({"--gt-map", path("truth.txt")}, "part.txt")).output;
  EXPECT_THAT(output, HasSubstr("62 matches on the overlap"));
  EXPECT_THAT(output, HasSubstr("% of the source's area, truly "));
  EXPECT_THAT(output, HasSubstr("IoU 0."));
  EXPECT_THAT(output, HasSubstr("precision 0."));
  EXPECT_THAT(
      run(arguments({"--gt-map", path("map.txt")})).output,
      HasSubstr("IoU 1.0000\n  unmatched                       precision none  recall none"));
}

TEST_F(EvalPartial, WhatHasNoDenominatorIsNull) {
  const nlohmann::json overlap = against("map.txt", "map.txt")["overlap"];
  EXPECT_EQ(overlap["iou"], 1);
  EXPECT_TRUE(overlap.at("unmatched_precision").is_null());
  EXPECT_TRUE(overlap.at("unmatched_recall").is_null());
}

TEST_F(EvalPartial, ZeroInAVtsIsAPointThatTheMeshLacks) {
  write("part", without(0, 60));
  folder_.write("target.vts", vts(without(40, 100)));
  folder_.write("source.vts", vts(without(150, 162)));
  const nlohmann::json result = json(truth(), "part.txt")["ground_truth"];
  EXPECT_EQ(result["template_points"], 162);
  EXPECT_EQ(result["template_points_on_surfaces"], 90);
  EXPECT_NEAR(result["overlap"]["iou"], 50.0 / 130, 1e-12);
  EXPECT_NEAR(result["overlap"]["unmatched_precision"], 20.0 / 60, 1e-12);
  EXPECT_NEAR(result["overlap"]["unmatched_recall"], 20.0 / 60, 1e-12);
  EXPECT_EQ(result["error_over_sqrt_area"]["samples"], 50);
  EXPECT_EQ(result["error_over_sqrt_area"]["maximum"], 0);
  EXPECT_THAT(run(arguments(truth(), "part.txt")).output, HasSubstr("% of template points, truly"));
  EXPECT_EQ(run(arguments(truth(), "map.txt")).output.find("recall none"), std::string::npos);
}

TEST_F(EvalPartial, WholeTruthAndMapSayNothingOfTheOverlap) {
  EXPECT_EQ(run(arguments(truth())).output.find("IoU"), std::string::npos);
}

TEST_F(EvalPartial, MapWithoutAnyMatchIsMeasured) {
  write("none", without(0, 162));
  for (const std::string& form : forms_) {
    const nlohmann::json result = against("map.txt", "none" + form);
    EXPECT_EQ(result["overlap"]["iou"], 0) << form;
    EXPECT_EQ(result["error_over_sqrt_area"]["samples"], 0) << form;
  }
  const std::string output = run(arguments({"--gt-map", path("map.txt")}, "none.txt")).output;
  EXPECT_THAT(output, HasSubstr("0 matches on the overlap"));
  EXPECT_EQ(output.find("error /"), std::string::npos);
  EXPECT_TRUE(against("none.txt", "none.txt")["overlap"].at("iou").is_null());
}

TEST_F(EvalPartial, BadTruthIsOneLine) {
  expect_refused("short.txt", "0\n1\n", "is for 2 vertices, but the source has 162");
  expect_refused("short.bary.txt", "0 1 0 0\n", "1 lines, but the source has 162 vertices");
  std::string lines;
  for (int v = 1; v <= 162; ++v) lines += fmt::format("{}\n", v);
  expect_refused(
      "from_one.txt", lines,
      "line 162: vertex 162 is out of range: the target has 162 vertices, numbered from 0");
  expect_refused("low.txt", "-2\n" + vts(without(0, 161)).substr(2), "line 1: vertex -2 is out of");
  expect_refused("face.bary.txt", "320 1 0 0\n", "line 1: face 320 is out of range");
  expect_refused("word.txt", "x\n", "line 1: ");
  expect_refused("pairs.txt", "0 0\n", "one vertex a line expected");
  expect_refused("truth.off", "", "the ending is not that of a map");
  EXPECT_EQ(run(arguments({"--gt-map", path("absent.txt")})).exit_code, 2);
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
