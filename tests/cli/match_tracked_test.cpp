// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>

#include <filesystem>
#include <numeric>
#include <set>

#include "isomatch/mesh/topology.h"
#include "match_program.h"
#include "program.h"

namespace isomatch::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class MatchTracked : public MatchProgram {
 protected:
  SurfaceMap points(const std::string& folder) const {
    return read_map(path(folder + "/source_to_target.bary.txt"), counts()).points;
  }

  /// Mean distance of corresponding points relative to the size of the creature's legs, about 1.
  static double mean_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).norm();
    return sum / static_cast<double>(a.size());
  }

  std::vector<Point> positions(const SurfaceMap& map) const {
    std::vector<Point> result;
    for (const SurfacePoint& point : map) result.push_back(position(target_, point));
    return result;
  }

  /// The message of a run with landmarks of this content, which must fail and leave nothing.
  std::string refusal(std::string_view landmarks) const {
    folder_.write("landmarks.txt", landmarks);
    const Outcome outcome = run(arguments("out", {"--landmarks", path("landmarks.txt")}));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_FALSE(fs::exists(path("out")));
    const std::string prefix = "isomatch: " + path("landmarks.txt") + ": ";
    EXPECT_THAT(outcome.errors, testing::StartsWith(prefix));
    return outcome.errors.substr(std::min(prefix.size(), outcome.errors.size()));
  }
};

TEST_F(MatchTracked, IsTheDefaultAndWritesPointsOnTriangles) {
  const Outcome outcome = run(arguments("out"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, HasSubstr("source vertices matched\nfit: good ("));
  EXPECT_THAT(outcome.output, HasSubstr("2 components"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("mirrored")));
  const SurfaceMap map = points("out");
  for (const SurfacePoint& point : map) EXPECT_GE(point.face, tetrahedron().num_faces());
  EXPECT_EQ(read_map(path("out/source_to_target.txt"), counts()).source_to_target,
            nearest_vertices(target_, map));
  EXPECT_FALSE(fs::exists(path("out/target_to_source.txt")));
  const nlohmann::json report = json("out/report.json");
  EXPECT_EQ(report["options"]["method"], "tracked");
  EXPECT_EQ(report["source_vertices_matched"], source_.num_vertices());
  EXPECT_EQ(report["source_vertices_unmatched"], 0);
  EXPECT_EQ(report["oriented"], true);
  EXPECT_TRUE(report["alternatives"].empty());
  EXPECT_GT(report["hypotheses"].size(), 0);
  for (const char* figure : {"energy", "distance", "deviation", "distortion", "orientation"})
    EXPECT_GT(report["map"][figure], 0) << figure;
  EXPECT_GE(report["ambiguity"], 0);
  EXPECT_GT(report["seconds"]["refinement"], 0);
}

TEST_F(MatchTracked, EveryVertexOfTheLargestComponentsHasAMatch) {
  ASSERT_EQ(run(arguments("out")).exit_code, 0);
  std::set<int> sources, targets;
  const MatchContent relation = read_matches(path("out/correspondence.txt"), counts());
  for (const Match& match : relation.matches) {
    sources.insert(match.source);
    targets.insert(match.target);
  }
  EXPECT_EQ(std::ssize(sources), source_.num_vertices());
  EXPECT_EQ(std::ssize(targets), target_.num_vertices() - kExtraVertices);
  EXPECT_EQ(*targets.begin(), kExtraVertices);
}

TEST_F(MatchTracked, MapIsRight) {
  const SynthShape source = creature(1);
  std::vector<int> target_truth = creature(2).ground_truth;
  for (int& v : target_truth) v += kExtraVertices;
  write_map(path("source.vts"), {.source_to_target = source.ground_truth});
  write_map(path("target.vts"), {.source_to_target = target_truth});
  ASSERT_EQ(run(arguments("out")).exit_code, 0);
  const Outcome outcome =
      run({"eval", path("source.off"), path("target.ply"), path("out/source_to_target.bary.txt"),
           "--gt-source", path("source.vts"), "--gt-target", path("target.vts"), "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const nlohmann::json truth = nlohmann::json::parse(outcome.output)["ground_truth"];
  // An edge is .03; the truth's vertices are off by up to half of that on either side.
  EXPECT_LT(truth["point_error_over_sqrt_area"]["mean"], 0.03);
  EXPECT_LT(truth["error_over_sqrt_area"]["mean"], 0.03);
}

TEST_F(MatchTracked, RegisteredSourceLiesOnTheTarget) {
  ASSERT_EQ(run(arguments("out")).exit_code, 0);
  const Mesh registered = read_mesh(path("out/registered.ply"));
  EXPECT_EQ(registered.faces, source_.faces);
  ASSERT_EQ(registered.vertices.size(), source_.vertices.size());
  EXPECT_LT(mean_distance(registered.vertices, positions(points("out"))), 0.02);
}

TEST_F(MatchTracked, VerticesOffTheSurfaceAreUnmatchedAndFollow) {
  const Outcome outcome = run({"match", path("target.ply"), path("source.off"), "-o", path("out"),
                               "--target-to-source", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
  EXPECT_THAT(bytes("out/source_to_target.bary.txt"),
              testing::StartsWith("-1 0 0 0\n-1 0 0 0\n-1 0 0 0\n-1 0 0 0\n"));
  const MapChecks turned{target_.num_vertices(), source_.num_vertices(), std::nullopt};
  const VertexMap map = read_map(path("out/source_to_target.txt"), turned).source_to_target;
  for (int v = 0; v < target_.num_vertices(); ++v)
    EXPECT_EQ(map[v] == kUnmatched, v < kExtraVertices);
  EXPECT_EQ(json("out/report.json")["source_vertices_unmatched"], kExtraVertices);
  const Mesh registered = read_mesh(path("out/registered.ply"));
  EXPECT_EQ(registered.faces, target_.faces);
  for (int v = 0; v < kExtraVertices; ++v) {
    int nearest = kExtraVertices;
    const auto distance = [&](int u) { return (target_.vertices[u] - target_.vertices[v]).norm(); };
    for (int u = nearest; u < target_.num_vertices(); ++u)
      if (distance(u) < distance(nearest)) nearest = u;
    EXPECT_NEAR((registered.vertices[v] - registered.vertices[nearest]).norm(), distance(nearest),
                1e-9);
  }

  const SurfaceMap inverse = read_map(path("out/target_to_source.bary.txt"), counts()).points;
  EXPECT_EQ(read_map(path("out/target_to_source.txt"), counts()).source_to_target,
            nearest_vertices(target_, inverse));
}

TEST_F(MatchTracked, AlternativesHaveFoldersOfTheirOwn) {
  const Outcome outcome = run(arguments("out", {"--alternatives", "4"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const nlohmann::json alternatives = json("out/report.json")["alternatives"];
  ASSERT_GT(alternatives.size(), 0);
  EXPECT_THAT(outcome.output,
              HasSubstr(std::to_string(alternatives.size()) + " of 4 alternatives found"));
  const auto cost = [](const nlohmann::json& map) {
    return map["energy"].get<double>() * map["distance"].get<double>();
  };
  double least = cost(json("out/report.json")["map"]);
  const SurfaceMap best = points("out");
  for (std::size_t k = 0; k < alternatives.size(); ++k) {
    const std::string folder = "out/alternatives/" + std::to_string(k + 1);
    EXPECT_EQ("out/" + alternatives[k]["folder"].get<std::string>(), folder);
    EXPECT_GE(cost(alternatives[k]), least);
    least = cost(alternatives[k]);
    const SurfaceMap map = points(folder);
    EXPECT_GT(mean_distance(positions(map), positions(best)), 0.05);
    EXPECT_EQ(read_map(path(folder + "/source_to_target.txt"), counts()).source_to_target,
              nearest_vertices(target_, map));
    EXPECT_EQ(read_mesh(path(folder + "/registered.ply")).faces, source_.faces);
  }
  EXPECT_FALSE(fs::exists(path("out/alternatives/" + std::to_string(alternatives.size() + 1))));
}

TEST_F(MatchTracked, LandmarksGoIntoTheReport) {
  const int source = creature(1).ground_truth[0];
  const int target = creature(2).ground_truth[0] + kExtraVertices;
  folder_.write("landmarks.txt",
                std::to_string(source) + " " + std::to_string(target) + " # hip\n");
  const Outcome outcome = run(arguments("out", {"--landmarks", path("landmarks.txt")}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(json("out/report.json")["options"]["landmarks"], path("landmarks.txt"));
}

TEST_F(MatchTracked, LandmarksMayBeASpreadsheetsAndFromOne) {
  const int source = creature(1).ground_truth[0];
  const int target = creature(2).ground_truth[0] + kExtraVertices;
  folder_.write("zero.txt", std::to_string(source) + " " + std::to_string(target));
  folder_.write("one.csv", "source;target\n" + std::to_string(source + 1) + ";" +
                               std::to_string(target + 1) + "\n");
  ASSERT_EQ(run(arguments("zero", {"--landmarks", path("zero.txt")})).exit_code, 0);
  ASSERT_EQ(run(arguments("one", {"--landmarks", path("one.csv"), "--one-based"})).exit_code, 0);
  EXPECT_EQ(bytes("zero/source_to_target.bary.txt"), bytes("one/source_to_target.bary.txt"));
  EXPECT_EQ(json("one/report.json")["options"]["one-based"], true);
  EXPECT_EQ(run(arguments("none", {"--one-based"})).exit_code, 2);
}

TEST_F(MatchTracked, BadLandmarksAreNamed) {
  EXPECT_THAT(refusal("0 10\n1 99999\n"), HasSubstr("line 2: vertex 99999 is out of range"));
  EXPECT_THAT(refusal("0 10\n7 11\n0 12\n"), HasSubstr("line 3: source vertex 0 has a landmark"));
  EXPECT_THAT(refusal("0 10\n5 2\n"), HasSubstr("target vertex 2 is not on the surface"));
  EXPECT_THAT(refusal("0\n1\n"), HasSubstr("line 1: expected an integer"));
  EXPECT_THAT(refusal("0 10 1 11\n"), HasSubstr("each landmark has a line of its own"));
  EXPECT_THAT(refusal("0 10\n1 11 1\n"), HasSubstr("line 2: more than a source and a target"));
  EXPECT_EQ(run(arguments("out", {"--landmarks", path("absent.txt")})).exit_code, 2);
}

TEST_F(MatchTracked, ThreadsChangeNoByte) {
  ASSERT_EQ(run(arguments("one", {"--threads", "1"})).exit_code, 0);
  ASSERT_EQ(run(arguments("three", {"--threads", "3"})).exit_code, 0);
  for (const std::string name :
       {"source_to_target.bary.txt", "correspondence.txt", "registered.ply"})
    EXPECT_EQ(bytes("one/" + name), bytes("three/" + name)) << name;
}

TEST_F(MatchTracked, ScaleAndPositionOfTheSourceDoNotMatter) {
  ASSERT_EQ(run(arguments("plain")).exit_code, 0);
  Random random(1);
  write_mesh(path("source.off"), scaled(moved(source_, random), 7));
  ASSERT_EQ(run(arguments("moved")).exit_code, 0);
  const std::vector<Point> plain = positions(points("plain")), moved = positions(points("moved"));
  EXPECT_LT(mean_distance(plain, moved), 0.02);
  EXPECT_LT(mean_distance(read_mesh(path("plain/registered.ply")).vertices,
                          read_mesh(path("moved/registered.ply")).vertices),
            0.02);
}

TEST_F(MatchTracked, SaysWhenOrientationCouldNotBeUsed) {
  Mesh turned = source_;
  Random random(1);
  for (Face& face : turned.faces)
    if (random.uniform() < 0.5) std::swap(face[0], face[1]);
  write_mesh(path("source.off"), turned);
  const Outcome plain = run(arguments("out"));
  ASSERT_EQ(plain.exit_code, 0) << plain.errors;
  EXPECT_THAT(plain.output, HasSubstr("the map may be mirrored"));
  EXPECT_EQ(json("out/report.json")["oriented"], false);
  const Outcome allowed = run(arguments("out", {"--allow-reflection"}));
  ASSERT_EQ(allowed.exit_code, 0) << allowed.errors;
  EXPECT_THAT(allowed.output, Not(HasSubstr("the map may be mirrored")));
}

}  // namespace
}  // namespace isomatch::test
