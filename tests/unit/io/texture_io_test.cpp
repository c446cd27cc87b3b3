// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/texture_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "isomatch/error.h"
#include "isomatch/io/mesh_io.h"
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

TEST(ReadTexturedMesh, NamesOfMaterialsStayWhole) {
  const auto names = [](const std::string& lines) {
    return read(kSquare + kCoordinates + lines + "\nf 1/1 2/2 3/3\n").texture.materials;
  };
  EXPECT_THAT(names("usemtl Body Upper"), ElementsAre("Body Upper"));
  EXPECT_THAT(names("usemtl \t Body  Upper \t\r"), ElementsAre("Body  Upper"));
  EXPECT_THAT(names("usemtl skin#1"), ElementsAre("skin#1"));
  EXPECT_THAT(names("usemtl # 1"), ElementsAre("# 1"));
  EXPECT_THAT(names("usemtl C:\\My Scans\\skin"), ElementsAre("C:\\My Scans\\skin"));
  EXPECT_THAT(names("usemtl Body \\\n  Upper"), ElementsAre("Body  Upper"));
  EXPECT_THAT(names("usemtl a b\nf 1 2 3\nusemtl a\nf 1 2 3\nusemtl a b"), ElementsAre("a b", "a"));
  EXPECT_THAT(names("usemtl"), ElementsAre());
  // Groups are passed over, whatever they are called.
  EXPECT_THAT(names("g left #1 arm\no my # thing\n# usemtl x\nusemtl b # c"), ElementsAre("b # c"));
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
  write_textured_mesh(path, bare, {"some where.mtl"});
  const TexturedMesh again = read_textured_mesh(path);
  EXPECT_EQ(again.mesh.vertices, mesh.mesh.vertices);
  EXPECT_EQ(again.mesh.faces, mesh.mesh.faces);
  EXPECT_EQ(again.texture.coordinates, mesh.texture.coordinates);
  EXPECT_EQ(again.texture.corners, mesh.texture.corners);
  EXPECT_THAT(material_libraries(path), ElementsAre("some where.mtl"));
  EXPECT_EQ(read_mesh(path).faces, mesh.mesh.faces);
}

TEST(WriteTexturedMesh, NamesOfMaterialsStayOnTheirLine) {
  const test::TemporaryFolder folder;
  TexturedMesh mesh = read(kSquare + kCoordinates + "usemtl a # b\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  mesh.texture.materials.emplace_back("two\nlines\\");
  mesh.texture.face_material[1] = 1;
  write_textured_mesh(folder.path("mesh.obj"), mesh);
  const TexturedMesh again = read_textured_mesh(folder.path("mesh.obj"));
  EXPECT_EQ(again.mesh.faces, mesh.mesh.faces);
  EXPECT_THAT(again.texture.materials, ElementsAre("a # b", "two lines\\"));
}

class MaterialLibraries : public testing::Test {
 protected:
  MaterialLibraries() {
    for (const char* name : {"a.mtl", "b.mtl", "my file.mtl", "c #1.mtl"}) folder_.write(name, " ");
  }

  std::vector<std::string> names(const std::string& lines) const {
    return material_libraries(folder_.write("mesh.obj", lines));
  }

  const test::TemporaryFolder folder_;
};

TEST_F(MaterialLibraries, NamesWithBlanksAndSeveralNamesAreToldByWhatIsThere) {
  EXPECT_THAT(names("mtllib my file.mtl\n"), ElementsAre("my file.mtl"));
  EXPECT_THAT(names("mtllib a.mtl b.mtl\n"), ElementsAre("a.mtl", "b.mtl"));
  EXPECT_THAT(names("mtllib a.mtl my file.mtl c #1.mtl\r\n"),
              ElementsAre("a.mtl", "my file.mtl", "c #1.mtl"));
  EXPECT_THAT(names("mtllib b.mtl\nv 0 0 0\nmtllib a.mtl\nmtllib b.mtl\n"),
              ElementsAre("b.mtl", "a.mtl"));
  EXPECT_THAT(names("mtllib a.mtl # colours\n# mtllib b.mtl\n"), ElementsAre("a.mtl"));
}

TEST_F(MaterialLibraries, MissingOnesStayWhole) {
  EXPECT_THAT(names("mtllib no such file.mtl\n"), ElementsAre("no such file.mtl"));
  EXPECT_THAT(names("mtllib no such.mtl none.MTL\n"), ElementsAre("no such.mtl", "none.MTL"));
  EXPECT_THAT(names("mtllib no such.mtl a.mtl other file\n"),
              ElementsAre("no such.mtl", "a.mtl", "other file"));
  EXPECT_THAT(names("mtllib C:\\My Scans\\body.mtl\n"), ElementsAre("C:\\My Scans\\body.mtl"));
  EXPECT_THAT(names("mtllib\n"), ElementsAre());
}

TEST_F(MaterialLibraries, LinesWithoutEndAreNamesWithoutEnd) {
  std::string line = "mtllib";
  for (int i = 0; i < 100000; ++i) line += " x";
  EXPECT_EQ(names(line + "\n")[0].size(), 199999U);
}

TEST(FindNamedFile, TakesTheWaysInWhichProgramsWriteNames) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("tex"));
  const std::string image = folder.write("tex/my low.png", "");
  const auto find = [&](const std::string& name) {
    return find_named_file(name, folder.path("body.mtl"));
  };
  EXPECT_EQ(find("tex/my low.png"), image);
  EXPECT_EQ(find("tex\\my low.png"), image);
  EXPECT_EQ(find("tex\\\\my low.png"), image);
  EXPECT_EQ(find(".\\tex\\my low.png"), folder.path("./tex/my low.png"));
  EXPECT_EQ(find("\"tex\\my low.png\""), image);
  EXPECT_EQ(find("tex/my\\ low.png"), image);
  EXPECT_EQ(find(image), image);
  for (const char* name : {"", "tex", "low.png", "C:\\tex\\my low.png"}) EXPECT_EQ(find(name), "");
  EXPECT_EQ(find(std::string(5000, 'x')), "");
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

/// The colours of the first of three vertices of which the channels have this type.
Eigen::Vector3d first_color(const std::string& type, const std::string& first,
                            const std::string& second = "0 0 0") {
  const test::TemporaryFolder folder;
  return read_vertex_colors(
      folder.write("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                   "property float z\nproperty " +
                       type + " red\nproperty " + type + " green\nproperty " + type +
                       " blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                       "0 0 0 " +
                       first + "\n1 0 0 " + second + "\n0 1 0 0 0 0\n3 0 1 2\n"))[0];
}

TEST(VertexColors, OfFloatsReachOneOr255) {
  const auto near = [](const Eigen::Vector3d& color, double r, double g, double b) {
    EXPECT_LT((color - Eigen::Vector3d(r, g, b)).norm(), 1e-6);
  };
  near(first_color("float", "0.2 0.5 1"), 0.2, 0.5, 1);
  near(first_color("float", "0.2 0.5 1.00001"), 0.2, 0.5, 1);
  near(first_color("double", "51 102 204"), 0.2, 0.4, 0.8);
  // The brightest vertex decides for all.
  near(first_color("float", "0.5 1 0", "0 0 2"), 0.5 / 255, 1. / 255, 0);
  near(first_color("float", "0 13107 -5", "65535 0 0"), 0, 0.2, 0);
  EXPECT_THROW(first_color("float", "0 1e9 0"), BadFile);
  EXPECT_THROW(first_color("float", "0 nan 0"), BadFile);
}

TEST(VertexColors, OfIntegersAreSharesOfTheirTypesRange) {
  const auto red = [](const std::string& type, const std::string& value) {
    return first_color(type, value + " 0 0")[0];
  };
  EXPECT_DOUBLE_EQ(red("uchar", "51"), 0.2);
  EXPECT_DOUBLE_EQ(red("uchar", "51.0"), 0.2);
  EXPECT_DOUBLE_EQ(red("char", "127"), 1);
  EXPECT_DOUBLE_EQ(red("ushort", "13107"), 0.2);
  EXPECT_DOUBLE_EQ(red("short", "32767"), 1);
  EXPECT_DOUBLE_EQ(red("int", "2147483647"), 1);
  EXPECT_DOUBLE_EQ(red("uint", "858993459"), 0.2);
  // Nobody means colours that are black to all eyes.
  EXPECT_DOUBLE_EQ(red("int", "51"), 0.2);
  EXPECT_DOUBLE_EQ(red("short", "-3"), 0);
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
