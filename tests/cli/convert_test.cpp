// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "isomatch/io/map_file.h"
#include "isomatch/io/model_io.h"
#include "match_program.h"
#include "program.h"
#include "support/maps.h"

namespace isomatch::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder with the map from a mesh to itself, and the mesh grown to twice its size as the
/// registered one, as `isomatch match` would write it. Vertex 0 is unmatched.
class Convert : public MatchProgram {
 protected:
  void SetUp() override {
    MatchProgram::SetUp();
    fs::create_directory(path("out"));
    SurfaceMap points = identity_map(source_);
    points[0] = {};
    write_map(path("out/source_to_target.bary.txt"), {.points = points});
    write_map(path("out/source_to_target.txt"),
              {.source_to_target = nearest_vertices(source_, points)});
    write_correspondence(path("out/correspondence.txt"),
                         to_correspondence(nearest_vertices(source_, points)));
    write_mesh(path("out/registered.ply"), scaled(source_, 2));
    const nlohmann::json side{{"file", path("source.off")},
                              {"vertices", source_.num_vertices()},
                              {"faces", source_.num_faces()}};
    folder_.write(
        "out/report.json",
        nlohmann::json{{"source", side}, {"target", side}, {"options", {{"method", "tracked"}}}}
            .dump());
  }

  /// What the program prints.
  std::string convert(const std::string& input, const std::string& output,
                      const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"convert", path(input), path(output)};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.errors, "");
    return outcome.output;
  }

  std::string refusal(const std::string& input, const std::string& output,
                      const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"convert", path(input), path(output)};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1);
    EXPECT_FALSE(fs::exists(path(output)));
    return outcome.errors;
  }
};

TEST_F(Convert, MeshesKeepTheirVertexOrderThroughAllFormats) {
  std::string input = "source.off";
  for (const char* output : {"a.glb", "b.mat", "c.gltf", "d.obj", "e.ply", "f.off"}) {
    convert(input, output);
    input = output;
  }
  const Mesh mesh = read_mesh(path("f.off"));
  EXPECT_EQ(mesh.faces, source_.faces);
  EXPECT_EQ(mesh.vertices, rounded_to_float(source_).vertices);
}

TEST_F(Convert, ResultsBecomeColouredMeshesWithTheOtherPose) {
  convert("out", "result.glb");
  const Model model = read_model(path("result.glb"));
  EXPECT_EQ(model.mesh.faces, source_.faces);
  ASSERT_EQ(model.poses.size(), 1U);
  EXPECT_EQ(model.poses[0].name, "registered");
  double largest = 0;
  for (const Point& p : source_.vertices) largest = std::max(largest, p.norm());
  for (int v = 0; v < model.mesh.num_vertices(); ++v)
    EXPECT_LT((model.poses[0].vertices[v] - 2 * source_.vertices[v]).norm(), 1e-6 * largest);
  ASSERT_EQ(model.colors.size(), source_.vertices.size());
  // What is unmatched is grey, as in pictures.
  EXPECT_EQ(model.colors[0].minCoeff(), model.colors[0].maxCoeff());
  EXPECT_GT((model.colors[1] - model.colors[500]).norm(), 0.01);
  convert("out", "result.ply");
  EXPECT_LT((read_model(path("result.ply")).colors[1] - model.colors[1]).norm(), 0.005);
}

TEST_F(Convert, ResultsBecomeMaps) {
  convert("out", "map.npz");
  const MapContent map = read_map(path("map.npz"));
  EXPECT_EQ(map.source_to_target[0], kUnmatched);
  EXPECT_EQ(map.source_to_target[700], 700);
  convert("map.npz", "map.txt");
  EXPECT_EQ(bytes("map.txt"), bytes("out/source_to_target.txt"));
  convert("map.npz", "map.bary.txt");
  EXPECT_EQ(bytes("map.bary.txt"), bytes("out/source_to_target.bary.txt"));
}

TEST_F(Convert, MapsChangeTheirNumbering) {
  folder_.write("ones.txt", "1\n2\n3\n");
  EXPECT_THAT(convert("ones.txt", "a.vts"), HasSubstr("say --one-based"));
  EXPECT_EQ(bytes("a.vts"), "2\n3\n4\n");
  EXPECT_EQ(convert("ones.txt", "a.map", {"--one-based", "--quiet"}), "");
  EXPECT_EQ(bytes("a.map"), "0\n1\n2\n");
  EXPECT_EQ(convert("a.vts", "b.txt", {"--write-one-based", "--quiet"}), "");
  EXPECT_EQ(bytes("b.txt"), "2\n3\n4\n");
  write_mesh(path("target.off"), tetrahedron());
  EXPECT_THAT(convert("b.txt", "c.txt", {"--target", path("target.off")}),
              HasSubstr("numbered from one, since it names the vertex past the last"));
  EXPECT_EQ(bytes("c.txt"), "1\n2\n3\n");
}

TEST_F(Convert, PointsNeedTheTarget) {
  write_mesh(path("target.off"), tetrahedron());
  folder_.write("map.txt", "3\n-1\n0\n");
  EXPECT_THAT(refusal("map.txt", "map.bary.txt"), HasSubstr("--target"));
  convert("map.txt", "map.bary.txt", {"--target", path("target.off")});
  EXPECT_EQ(bytes("map.bary.txt"), "1 0 0 1\n-1 0 0 0\n0 1 0 0\n");
  EXPECT_THAT(refusal("map.bary.txt", "back.txt"), HasSubstr("--target"));
  convert("map.bary.txt", "back.txt", {"--target", path("target.off")});
  EXPECT_EQ(bytes("back.txt"), "3\n-1\n0\n");
  EXPECT_THAT(refusal("map.txt", "map.vts"), HasSubstr("unmatched"));
}

TEST_F(Convert, OneMeshOfASceneIsChosenByItsName) {
  convert("source.off", "a.glb");
  convert("a.glb", "all.off");
  convert("a.glb", "one.off", {"--mesh", "mesh"});
  EXPECT_EQ(bytes("one.off"), bytes("all.off"));
  EXPECT_THAT(refusal("a.glb", "b.off", {"--mesh", "eye"}), HasSubstr("only 'mesh'"));
}

TEST_F(Convert, BadInputIsRefused) {
  EXPECT_THAT(refusal("nowhere.glb", "a.off"), HasSubstr("nowhere.glb"));
  EXPECT_THAT(refusal("source.off", "a.stl"), HasSubstr("STL files are only read"));
  EXPECT_THAT(refusal("source.off", "a.npz"), HasSubstr("a.npz"));
  EXPECT_THAT(refusal("out", "a.png"), HasSubstr("a.png"));
  EXPECT_THAT(refusal("out", "a.glb", {"--alternative", "2"}), HasSubstr("no alternative 2"));
  EXPECT_THAT(refusal("source.off", "a.ply", {"--one-based"}), HasSubstr("for maps"));
  EXPECT_THAT(refusal("out", "a.glb", {"--write-one-based"}), HasSubstr("for maps"));
  EXPECT_THAT(refusal("source.off", "a.ply", {"--mesh", "body"}), HasSubstr("glTF"));
  EXPECT_THAT(refusal("out", "a.glb", {"--mesh", "body"}), HasSubstr("--mesh is for meshes"));
  EXPECT_THAT(refusal("source.off", "a.ply", {"--target", path("source.off")}),
              HasSubstr("for maps and results"));
  EXPECT_THAT(refusal("source.off", "a.ply", {"--alternative", "1"}), HasSubstr("for results"));
  folder_.write("a.npy", "no such thing");
  EXPECT_THAT(refusal("a.npy", "a.txt"), HasSubstr("'.npy' is not that of a mesh"));
  for (const char* name : {"bad.glb", "bad.gltf", "bad.mat", "bad.npz"}) {
    folder_.write(name, "no such thing");
    EXPECT_THAT(refusal(name, name[4] == 'n' ? "a.txt" : "a.off"), HasSubstr(name));
  }
}

TEST_F(Convert, MatchReadsTheNewFormats) {
  convert("source.off", "source.glb");
  convert("target.ply", "target.mat");
  const Outcome outcome =
      run({"match", path("source.glb"), path("target.mat"), "-o", path("matched")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  convert("matched", "matched.glb");
  EXPECT_EQ(read_model(path("matched.glb")).poses.size(), 1U);
}

}  // namespace
}  // namespace isomatch::test
