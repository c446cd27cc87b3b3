// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/texture_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "isomatch/error.h"
#include "isomatch/mesh_io.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

using testing::ElementsAre;
using testing::EndsWith;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kCoordinates = "vt 0 0\nvt 1 0\nvt 1 1 0\nvt 0 1\n";

TexturedMesh read(const std::string& content) {
  const test::TemporaryFolder folder;
  return read_textured_mesh(folder.write("mesh.obj", content));
}

std::string error_of(const std::string& content) {
  try {
    read(content);
  } catch (const BadFile& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(ReadTexturedMesh, CutsTexturesLikePolygons) {
  const TexturedMesh quad = read(kSquare + kCoordinates + "usemtl skin\nf 1/4 2/3 3/2 4/1\n");
  EXPECT_THAT(quad.mesh.faces, ElementsAre(Face{0, 1, 2}, Face{0, 2, 3}));
  EXPECT_THAT(quad.texture.corners, ElementsAre(Face{3, 2, 1}, Face{3, 1, 0}));
  EXPECT_THAT(quad.texture.face_material, ElementsAre(0, 0));
  EXPECT_THAT(quad.texture.materials, ElementsAre("skin"));
}

TEST(ReadTexturedMesh, TakesCornersInEveryForm) {
  const TexturedMesh mesh =
      read(kSquare + kCoordinates +
           "f 1 2 3\nusemtl a\nf 1/1/5 2/2/5 3/-2/5\nusemtl b\nf 1//1 2//2 3//3\nusemtl a\n"
           "f 1/1 2/2 4\n");
  constexpr int kNone = Texture::kNone;
  const Face bare{kNone, kNone, kNone};
  EXPECT_THAT(mesh.texture.corners, ElementsAre(bare, Face{0, 1, 2}, bare, bare));
  EXPECT_THAT(mesh.texture.face_material, ElementsAre(kNone, 0, 1, 0));
}

TEST(ReadTexturedMesh, BadFilesAreNamed) {
  EXPECT_THAT(error_of(kSquare + "f 1 2 3\n"), EndsWith("no face has texture coordinates"));
  EXPECT_THAT(error_of(kSquare + "vt 0 0\nf 1/1 2/1 3/2\n"),
              EndsWith("texture coordinates 2 are out of range, there are 1"));
  EXPECT_THAT(error_of(kSquare + "vt 0 0\nf 1/0 2/1 3/1\n"),
              EndsWith("line 6: bad index of texture coordinates in '1/0'"));
  EXPECT_THAT(error_of(kSquare + "vt 0 0\nf 1/x 2/1 3/1\n"),
              EndsWith("line 6: bad index of texture coordinates in '1/x'"));
  EXPECT_THAT(error_of(kSquare + "vt nan 0\n"),
              EndsWith("line 5: expected a finite number, found 'nan'"));
}

TEST(WriteTexturedMesh, RoundTripsAreExact) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("mesh.obj");
  const TexturedMesh mesh = read(kSquare + "vt 0.1 0.3\nvt 1e-9 1\nvt 3 -2\n" +
                                 "usemtl a b\nf 1/1 2/2 3/3\nf 1 3 4\nusemtl c\nf 3/3 2/2 1/1\n");
  TexturedMesh bare = mesh;
  bare.texture.face_material[1] = Texture::kNone;
  write_textured_mesh(path, bare, "some where.mtl");
  const TexturedMesh again = read_textured_mesh(path);
  EXPECT_EQ(again.mesh.vertices, mesh.mesh.vertices);
  EXPECT_EQ(again.mesh.faces, mesh.mesh.faces);
  EXPECT_EQ(again.texture.coordinates, mesh.texture.coordinates);
  EXPECT_EQ(again.texture.corners, mesh.texture.corners);
  EXPECT_THAT(material_libraries(path), ElementsAre("some where.mtl"));
  EXPECT_EQ(read_mesh(path).faces, mesh.mesh.faces);
}

TEST(VertexColors, RoundTripsAreExactToTheByte) {
  const test::TemporaryFolder folder;
  const Mesh mesh = test::tetrahedron();
  const VertexColors colors{{0, 0.2, 1}, {1, 1, 1}, {0.4, 0.6, 0.8}, {0, 0, 0}};
  write_colored_mesh(folder.path("a.ply"), mesh, colors);
  const VertexColors again = read_vertex_colors(folder.path("a.ply"));
  ASSERT_EQ(again.size(), 4U);
  for (int v = 0; v < 4; ++v) EXPECT_LT((again[v] - colors[v]).norm(), 1e-12);
  EXPECT_EQ(read_mesh(folder.path("a.ply")).vertices, mesh.vertices);
}

TEST(VertexColors, AreReadFromText) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty uchar blue\n"
      "property float y\nproperty uchar green\nproperty float z\nproperty uchar red\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 255 0 0 0 51\n1 0 0 0 0 0\n0 0 1 0 0 0\n3 0 1 2\n");
  EXPECT_LT((read_vertex_colors(path)[0] - Eigen::Vector3d(0.2, 0, 1)).norm(), 1e-12);
}

TEST(VertexColors, MissingOnesAreReported) {
  const test::TemporaryFolder folder;
  write_mesh(folder.path("a.ply"), test::tetrahedron());
  EXPECT_THROW(read_vertex_colors(folder.path("a.ply")), BadFile);
  EXPECT_THROW(write_colored_mesh(folder.path("a.ply"), test::tetrahedron(), {}), InvalidInput);
  EXPECT_THROW(write_colored_mesh(folder.path("a.off"), test::tetrahedron(), VertexColors(4)),
               BadFile);
}

}  // namespace
}  // namespace isomatch
