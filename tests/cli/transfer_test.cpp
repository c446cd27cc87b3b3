// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "isomatch/io/material_libraries.h"
#include "isomatch/io/model_io.h"
#include "isomatch/io/values_io.h"
#include "match_program.h"
#include "program.h"

namespace isomatch::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder with the map from a creature to a copy of it, as `isomatch match` would write it. A
/// small tetrahedron far from the copy, with its lowest numbers, has no partner.
class Transfer : public MatchProgram {
 protected:
  void SetUp() override {
    MatchProgram::SetUp();
    write_mesh(path("copy.ply"), copy_);
    fs::create_directory(path("out"));
    SurfaceMap source_to_target;
    VertexMap vertices;
    for (int v = 0; v < source_.num_vertices(); ++v) {
      source_to_target.push_back(corner(copy_, v + kExtraVertices));
      vertices.push_back(v + kExtraVertices);
    }
    write_map(path("out/source_to_target.bary.txt"), {.points = source_to_target});
    write_map(path("out/source_to_target.txt"), {.source_to_target = vertices});
    const nlohmann::json report{{"source", side("source.off", source_)},
                                {"target", side("copy.ply", copy_)},
                                {"options", {{"method", "tracked"}}}};
    folder_.write("out/report.json", report.dump());
  }

  nlohmann::json side(const std::string& file, const Mesh& mesh) const {
    return {{"file", path(file)}, {"vertices", mesh.num_vertices()}, {"faces", mesh.num_faces()}};
  }

  static SurfacePoint corner(const Mesh& mesh, int vertex) {
    for (int f = 0; f < mesh.num_faces(); ++f) {
      for (int k = 0; k < 3; ++k) {
        if (mesh.faces[f][k] != vertex) continue;
        SurfacePoint point{f, {}};
        point.weights[k] = 1;
        return point;
      }
    }
    return {};
  }

  Outcome carry(const std::vector<std::string>& more, const std::string& output) const {
    std::vector<std::string> all{"transfer", path("out"), "-o", path(output)};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }

  void expect_carried(const std::vector<std::string>& more, const std::string& output) const {
    const Outcome outcome = carry(more, output);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
  }

  std::string refusal(const std::vector<std::string>& more,
                      const std::string& output = "refused") const {
    const Outcome outcome = carry(more, output);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1);
    EXPECT_FALSE(fs::exists(path(output)));
    return outcome.errors;
  }

  static Mesh far_tetrahedron() {
    Mesh mesh = scaled(tetrahedron(), 0.01);
    for (Point& p : mesh.vertices) p += Point(10, 10, 10);
    return mesh;
  }

  /// Of each source vertex its number modulo 7.
  std::string labels_file() const {
    std::string text;
    for (int v = 0; v < source_.num_vertices(); ++v) text += std::to_string(v % 7) + "\n";
    return folder_.write("labels.txt", text);
  }

  const Mesh copy_ = combined(far_tetrahedron(), source_);
};

TEST_F(Transfer, LabelsGoOverAndBack) {
  expect_carried({"--labels", labels_file()}, "carried.txt");
  const std::vector<int> carried = read_labels(path("carried.txt"), copy_.num_vertices());
  for (int v = 0; v < source_.num_vertices(); ++v) EXPECT_EQ(carried[v + kExtraVertices], v % 7);
  for (int v = 0; v < kExtraVertices; ++v) EXPECT_EQ(carried[v], kNoLabel);
  expect_carried({"--labels", path("carried.txt"), "--reverse"}, "back.txt");
  EXPECT_EQ(bytes("back.txt"), bytes("labels.txt"));
}

TEST_F(Transfer, ValuesOfWhatIsUnmatchedAreUnknown) {
  Eigen::MatrixXd values(source_.num_vertices(), 2);
  for (int v = 0; v < source_.num_vertices(); ++v) values.row(v) << v, 0.5 * v;
  write_values(path("values.txt"), values);
  expect_carried({"--values", path("values.txt")}, "carried.txt");
  const Eigen::MatrixXd carried = read_values(path("carried.txt"), copy_.num_vertices());
  EXPECT_TRUE(carried.topRows(kExtraVertices).array().isNaN().all());
  EXPECT_LT((carried.bottomRows(source_.num_vertices()) - values).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(Transfer, ColorsGoIntoAMesh) {
  write_model(path("painted.ply"),
              {.mesh = source_, .colors = VertexColors(source_.vertices.size(), {1, 0.2, 0})});
  expect_carried({"--colors", path("painted.ply")}, "carried.ply");
  const VertexColors colors = read_vertex_colors(path("carried.ply"));
  EXPECT_LT((colors[0] - Eigen::Vector3d(0.5, 0.5, 0.5)).norm(), 0.01);
  EXPECT_LT((colors[kExtraVertices] - Eigen::Vector3d(1, 0.2, 0)).norm(), 1e-9);
  EXPECT_EQ(read_mesh(path("carried.ply")).faces, copy_.faces);
}

TEST_F(Transfer, LandmarksInBothForms) {
  const std::string landmarks = folder_.write("landmarks.txt", "5\n700\n5\n");
  expect_carried({"--landmarks", landmarks}, "carried.txt");
  EXPECT_EQ(bytes("carried.txt"), "9\n704\n9\n");
  // .vts files are numbered from one, read and written.
  expect_carried({"--landmarks", folder_.write("landmarks.vts", "6\n701\n6\n")}, "carried.vts");
  EXPECT_EQ(bytes("carried.vts"), "10\n705\n10\n");
  expect_carried({"--landmarks", landmarks}, "carried.bary.txt");
  const SurfaceMap points =
      read_map(path("carried.bary.txt"), {.source_vertices = 3, .target_faces = copy_.num_faces()})
          .points;
  EXPECT_EQ(position(copy_, points[1]), copy_.vertices[704]);
}

TEST_F(Transfer, SkinningWeightsSumToOne) {
  SkinWeights weights(source_.vertices.size(), {{3, 0.5}, {4, 0.5}});
  write_skin_weights(path("skin.txt"), weights);
  expect_carried({"--skin", path("skin.txt")}, "carried.txt");
  const SkinWeights carried = read_skin_weights(path("carried.txt"), copy_.num_vertices());
  EXPECT_TRUE(carried[0].empty());
  EXPECT_EQ(carried[kExtraVertices], weights[0]);
}

class TransferTexture : public Transfer {
 protected:
  void SetUp() override {
    Transfer::SetUp();
    fs::create_directories(path("art/tex"));
    for (const char* image : {"my fur.png", "skin#2.jpg", "tex/low.png"})
      folder_.write("art/" + std::string(image), "not looked at");
  }

  /// Writes art/source.obj: half of the faces have the one, half the other material.
  void write_source(const std::string& first, const std::string& second,
                    const std::vector<std::string>& libraries = {"source.mtl"}) const {
    Model textured{.mesh = source_};
    textured.texture.coordinates = {{0, 0}, {1, 0}, {0, 1}};
    textured.texture.corners.assign(source_.faces.size(), {0, 1, 2});
    textured.texture.materials = {first, second};
    for (int f = 0; f < source_.num_faces(); ++f)
      textured.texture.face_material.push_back(f < source_.num_faces() / 2 ? 0 : 1);
    write_model(path("art/source.obj"), textured, {libraries});
  }

  /// What is said on standard error of the texture that becomes `output`.
  std::string warnings(const std::string& output) const {
    const Outcome outcome = carry({"--texture", path("art/source.obj"), "--keep-faces"}, output);
    EXPECT_EQ(outcome.exit_code, 0);
    return outcome.errors;
  }
};

TEST_F(TransferTexture, UsesImagesFromWhereTheyAre) {
  write_source("fur", "skin");
  folder_.write("art/source.mtl",
                "newmtl fur\nKd 1 1 1\nmap_Kd -s 1 1 1 my fur.png\r\n"
                "newmtl skin\nmap_Kd -bm 0.5 -clamp on skin#2.jpg # of May\nbump tex\\low.png");
  EXPECT_EQ(warnings("carried.obj"), "");
  EXPECT_THAT(bytes("carried.mtl"), HasSubstr("map_Kd -s 1 1 1 art/my fur.png\n"));
  EXPECT_THAT(bytes("carried.mtl"),
              HasSubstr("map_Kd -bm 0.5 -clamp on art/skin#2.jpg # of May\n"));
  EXPECT_THAT(bytes("carried.mtl"), HasSubstr("bump art/tex/low.png\n"));
  const TexturedMesh carried = read_textured_mesh(path("carried.obj"));
  EXPECT_EQ(carried.mesh.faces, copy_.faces);
  EXPECT_FALSE(carried.texture.covers(0));
  EXPECT_TRUE(carried.texture.covers(kExtraVertices));
  EXPECT_EQ(material_libraries(path("carried.obj")), std::vector<std::string>{"carried.mtl"});
  expect_carried({"--texture", path("art/source.obj"), "--image", path("art/my fur.png")},
                 "again.obj");
  EXPECT_THAT(bytes("again.mtl"), HasSubstr("map_Kd art/my fur.png\n"));
}

TEST_F(TransferTexture, NamesWithBlanksAndSignsStayWhole) {
  write_source("Body Upper", "Body #2", {"my # file.mtl", "more.mtl"});
  folder_.write("art/my # file.mtl", "newmtl Body Upper\nmap_Kd my fur.png\n");
  folder_.write("art/more.mtl", "newmtl Body #2\nKd 1 0 0\nnewmtl Body Upper\nKd 0 0 1\n");
  EXPECT_EQ(warnings("my #out.obj"), "");
  EXPECT_THAT(read_textured_mesh(path("my #out.obj")).texture.materials,
              testing::UnorderedElementsAre("Body Upper", "Body #2"));
  // The first file that has a material counts.
  EXPECT_EQ(bytes("my #out.mtl"),
            "newmtl Body Upper\nmap_Kd art/my fur.png\nnewmtl Body #2\nKd 1 0 0\n"
            "newmtl none\nKd 0.5 0.5 0.5\n");
}

TEST_F(TransferTexture, MissingImagesKeepTheirNames) {
  write_source("fur", "skin");
  const std::string material =
      "newmtl fur\nmap_Kd my my fur.png\nmap_Ks -s 1 1 1 C:\\Users\\me\\My Scans\\my fur.png\n"
      "newmtl skin\nKd 1 1 1\n";
  folder_.write("art/source.mtl", material);
  EXPECT_EQ(
      warnings("carried.obj"),
      "warning: " + path("art/source.mtl") +
          ": images that are not there: C:\\Users\\me\\My Scans\\my fur.png, my my fur.png\n");
  EXPECT_THAT(bytes("carried.mtl"), testing::StartsWith(material));
  EXPECT_TRUE(read_textured_mesh(path("carried.obj")).texture.covers(kExtraVertices));
}

TEST_F(TransferTexture, MissingLibrariesKeepTheirNames) {
  write_source("fur", "skin", {"source.mtl", "D:\\no such.mtl"});
  folder_.write("art/source.mtl", "newmtl fur\nKd 1 1 1\n");
  EXPECT_EQ(warnings("carried.obj"),
            "warning: " + path("art/source.obj") +
                ": files of materials that are not there: D:\\no such.mtl\n");
  EXPECT_THAT(material_libraries(path("carried.obj")),
              testing::ElementsAre("carried.mtl", "D:\\no such.mtl"));
  EXPECT_THAT(bytes("carried.mtl"), testing::StartsWith("newmtl fur\nKd 1 1 1\nnewmtl none\n"));
}

TEST_F(Transfer, PosesGoIntoAFolder) {
  Mesh frame = source_;
  for (Point& p : frame.vertices) p = 2 * p + Point(1, 0, 0);
  write_mesh(path("frame_01.off"), frame);
  expect_carried({"--poses", path("source.off"), path("frame_01.off")}, "poses");
  const Mesh still = read_mesh(path("poses/source.ply"));
  const Mesh grown = read_mesh(path("poses/frame_01.ply"));
  EXPECT_EQ(still.faces, copy_.faces);
  const Point first = still.vertices[100], second = still.vertices[500];
  EXPECT_NEAR((grown.vertices[100] - grown.vertices[500]).norm(), 2 * (first - second).norm(),
              1e-6);
}

TEST_F(Transfer, BadInputIsRefused) {
  const std::string labels = labels_file();
  EXPECT_THAT(refusal({}), HasSubstr("what to carry is missing: --values, --labels"));
  EXPECT_THAT(refusal({"--labels", labels, "--values", labels}),
              HasSubstr("--values and --labels cannot be carried at once"));
  EXPECT_THAT(refusal({"--labels", path("nowhere.txt")}), HasSubstr("nowhere.txt"));
  EXPECT_THAT(refusal({"--labels", labels, "--reverse"}), HasSubstr("labels.txt"));
  EXPECT_THAT(refusal({"--labels", labels, "--alternative", "3"}), HasSubstr("no alternative 3"));
  EXPECT_THAT(refusal({"--labels", labels, "--keep-faces"}), HasSubstr("--keep-faces"));
  EXPECT_THAT(refusal({"--poses", path("copy.ply")}), HasSubstr("copy.ply"));
  EXPECT_THAT(refusal({"--poses", path("source.off"), path("source.off")}),
              HasSubstr("two frames"));
  EXPECT_THAT(refusal({"--landmarks", folder_.write("l.txt", "1\n100000\n")}, "refused.txt"),
              HasSubstr("line 2"));
  EXPECT_THAT(refusal({"--colors", path("copy.ply")}, "refused.ply"), HasSubstr("no colours"));
}

}  // namespace
}  // namespace isomatch::test
