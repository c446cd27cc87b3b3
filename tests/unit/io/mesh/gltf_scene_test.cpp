// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "isomatch/error.h"
#include "isomatch/io/model_io.h"
#include "support/gltf_files.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

using test::GltfText;
using test::tetrahedron;
using test::tetrahedron_buffer;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kBody = R"({"name":"body","primitives":[{"attributes":{"POSITION":0},)"
                              R"("indices":1}]})";
constexpr const char* kEye = R"({"name":"eye","primitives":[{"attributes":{"POSITION":0},)"
                             R"("indices":1}]})";
constexpr const char* kLines = R"({"name":"axes","primitives":[{"attributes":{"POSITION":0},)"
                               R"("mode":1}]})";

/// A file that is read in every way.
class GltfScene : public testing::Test {
 protected:
  void write(const GltfText& text) {
    path_ = folder_.write("a.glb", test::glb(text.json(), tetrahedron_buffer()));
  }
  Mesh read(const MeshReadOptions& options = {}) { return read_mesh(path_, &report_, options); }

  test::TemporaryFolder folder_;
  std::string path_;
  MeshReadReport report_;
};

TEST_F(GltfScene, AllMeshesAreReadWhereTheirNodesPutThem) {
  write({.scenes = R"({"nodes":[0,2]})",
         .nodes = R"({"mesh":1,"translation":[10,0,0],"children":[1]},)"
                  R"({"name":"left","mesh":0,"scale":[2,2,2]},{"mesh":1})",
         .meshes = std::string(kBody) + "," + kEye});
  const Mesh mesh = read();
  ASSERT_EQ(mesh.num_vertices(), 12);
  ASSERT_EQ(mesh.num_faces(), 12);
  const Point corner = tetrahedron().vertices[1];
  EXPECT_EQ(mesh.vertices[1], Point(corner + Point(10, 0, 0)));
  EXPECT_EQ(mesh.vertices[5], Point(2 * corner + Point(10, 0, 0)));
  EXPECT_EQ(mesh.vertices[9], corner);
  const Face last = tetrahedron().faces[3];
  EXPECT_EQ(mesh.faces[11], (Face{last[0] + 8, last[1] + 8, last[2] + 8}));
  EXPECT_THAT(report_.meshes, ElementsAre("eye", "left", "eye"));
  EXPECT_THAT(report_.warnings, IsEmpty());
  EXPECT_EQ(read_model(path_).mesh.faces, mesh.faces);
}

TEST_F(GltfScene, OnlyTheMirroredInstanceIsTurned) {
  write({.scenes = R"({"nodes":[0,1]})",
         .nodes = R"({"mesh":0},{"mesh":0,"scale":[1,-1,1]})",
         .meshes = kBody});
  const Mesh mesh = read();
  const auto [a, b, c] = tetrahedron().faces[2];
  EXPECT_EQ(mesh.faces[2], (Face{a, b, c}));
  EXPECT_EQ(mesh.faces[6], (Face{a + 4, c + 4, b + 4}));
}

TEST_F(GltfScene, AMeshIsChosenByItsNameOrItsNodes) {
  write({.scenes = R"({"nodes":[0,1]})",
         .nodes = R"({"mesh":0},{"name":"left","mesh":1,"translation":[1,0,0]})",
         .meshes = std::string(kBody) + "," + kEye + "," + kLines});
  EXPECT_EQ(read({.mesh = "body"}).vertices, tetrahedron().vertices);
  EXPECT_EQ(read({.mesh = "left"}).vertices[0], Point(1, 0, 0));
  EXPECT_EQ(read({.mesh = "eye"}).num_vertices(), 4);
  EXPECT_EQ(read_model(path_, nullptr, {.mesh = "eye"}).mesh.num_vertices(), 4);
  try {
    read({.mesh = "tail"});
    FAIL();
  } catch (const BadFile& error) {
    EXPECT_THAT(error.what(), HasSubstr("has no mesh 'tail', only 'body', 'left', 'axes'"));
  }
}

TEST_F(GltfScene, OtherFormatsHaveNoMeshToChoose) {
  const std::string path = folder_.path("a.off");
  write_mesh(path, tetrahedron());
  EXPECT_THROW(read_mesh(path, nullptr, {.mesh = "body"}), BadFile);
}

TEST_F(GltfScene, LinesInFrontOfTheBodyAreWarnedOf) {
  write({.scenes = R"({"nodes":[0,1]})",
         .nodes = R"({"mesh":0},{"mesh":1})",
         .meshes = std::string(kLines) + "," + kBody});
  EXPECT_EQ(read().faces, tetrahedron().faces);
  EXPECT_THAT(report_.warnings, ElementsAre("a part of lines or points is left out"));
  EXPECT_THAT(report_.meshes, ElementsAre("body"));
}

TEST_F(GltfScene, MeshesOutsideOfTheSceneAreWarnedOf) {
  write({.meshes = std::string(kBody) + "," + kEye});
  EXPECT_EQ(read().num_vertices(), 4);
  EXPECT_THAT(report_.warnings, ElementsAre("not in the scene that is shown, and left out: 'eye'"));
}

TEST_F(GltfScene, WithoutASceneAllMeshesAreRead) {
  write({.scenes = "", .nodes = "{}", .meshes = std::string(kBody) + "," + kEye});
  EXPECT_EQ(read().num_vertices(), 8);
  write({.scenes = "", .nodes = "{}"});
  read();
  EXPECT_THAT(report_.meshes, ElementsAre("mesh_0"));
  write({.scenes = "",
         .nodes = R"({"children":[1],"translation":[1,0,0]},{"mesh":0})",
         .meshes = kBody});
  EXPECT_EQ(read().vertices[0], Point(1, 0, 0));
}

TEST_F(GltfScene, TooManyInstancesAreRefused) {
  std::string nodes, roots;
  for (int n = 0; n < 3000; ++n) {
    nodes += R"({"mesh":0},)";
    roots += std::to_string(n) + ",";
  }
  std::string parts;
  for (int k = 0; k < 6000; ++k) parts += R"({"attributes":{"POSITION":0},"indices":1},)";
  parts.pop_back();
  nodes.pop_back();
  roots.pop_back();
  write({.parts = parts, .scenes = R"({"nodes":[)" + roots + "]}", .nodes = nodes});
  EXPECT_THROW(read(), BadFile);
}

}  // namespace
}  // namespace isomatch
