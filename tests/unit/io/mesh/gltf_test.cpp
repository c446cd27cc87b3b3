// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "isomatch/error.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/io/model_io.h"
#include "support/gltf_files.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

using test::base64;
using test::glb;
using test::GltfText;
using test::read_content;
using test::read_error;
using test::tetrahedron;
using test::tetrahedron_buffer;
using testing::HasSubstr;

Mesh read_glb(const GltfText& text) {
  return read_content("glb", glb(text.json(), tetrahedron_buffer()));
}

std::string glb_error(const GltfText& text) {
  return read_error("glb", glb(text.json(), tetrahedron_buffer()));
}

/// The text with one thing in it replaced by another.
std::string json_with(const std::string& before, const std::string& after) {
  std::string json = GltfText().json();
  const std::size_t at = json.find(before);
  EXPECT_NE(at, std::string::npos);
  return json.replace(at, before.size(), after);
}

std::string error_with(const std::string& before, const std::string& after) {
  return read_error("glb", glb(json_with(before, after), tetrahedron_buffer()));
}

TEST(Gltf, BufferInsideInAUriOrInAFileBeside) {
  const Mesh mesh = tetrahedron();
  EXPECT_EQ(read_glb({}).vertices, mesh.vertices);
  EXPECT_EQ(read_glb({}).faces, mesh.faces);
  const std::string data = ",\"uri\":\"data:application/octet-stream;base64,";
  const GltfText inside{.uri = data + base64(tetrahedron_buffer()) + "\""};
  EXPECT_EQ(read_content("gltf", inside.json()).vertices, mesh.vertices);
  const test::TemporaryFolder folder;
  folder.write("my data.bin", tetrahedron_buffer());
  const GltfText beside{.uri = R"(,"uri":"my%20data.bin")"};
  EXPECT_EQ(read_mesh(folder.write("a.gltf", beside.json())).faces, mesh.faces);
}

TEST(Gltf, NodesMoveTheMesh) {
  const Mesh moved = read_glb({.node = R"(,"translation":[1,2,3],"scale":[2,2,2])"});
  for (int v = 0; v < 4; ++v)
    EXPECT_EQ(moved.vertices[v], Point(2 * tetrahedron().vertices[v] + Point(1, 2, 3)));
  // A quarter turn about z.
  const Mesh turned =
      read_glb({.node = R"(,"rotation":[0,0,0.7071067811865476,0.7071067811865476])"});
  EXPECT_LT((turned.vertices[1] - Point(0, 1.5, 0)).norm(), 1e-12);
  const Mesh column_major = read_glb({.node = R"(,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1])"});
  EXPECT_EQ(column_major.vertices[0], Point(5, 6, 7));
}

TEST(Gltf, TransformsMultiplyFromTheRootDown) {
  const std::string nested =
      json_with(R"("nodes":[{"mesh":0}])",
                R"("nodes":[{"children":[1],"scale":[2,2,2]},{"mesh":0,"translation":[1,0,0]}])");
  const Mesh mesh = read_content("glb", glb(nested, tetrahedron_buffer()));
  EXPECT_EQ(mesh.vertices[0], Point(2, 0, 0));
}

TEST(Gltf, MirrorImagesAreNotInsideOut) {
  const Mesh mesh = read_glb({.node = R"(,"scale":[-1,1,1])"});
  const Mesh given = tetrahedron();
  for (int f = 0; f < 4; ++f) {
    const auto& [a, b, c] = given.faces[f];
    EXPECT_EQ(mesh.faces[f], (Face{a, c, b}));
  }
}

TEST(Gltf, ASkinnedMeshStaysWhereItIs) {
  const GltfText skinned{.node = R"(,"translation":[9,9,9],"skin":0)",
                         .more = R"(,"skins":[{"joints":[0]}])"};
  EXPECT_EQ(read_glb(skinned).vertices, tetrahedron().vertices);
}

TEST(Gltf, StripsFansAndPartsThatShareVertices) {
  const std::string part = R"({"attributes":{"POSITION":0},"mode":)";
  const Mesh mesh = read_glb({.parts = part + "5}," + part + "6}," + part + "0}"});
  EXPECT_EQ(mesh.num_vertices(), 4);
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {2, 1, 3}, {0, 1, 2}, {0, 2, 3}}));
}

TEST(Gltf, PartsWithOwnPositionsFollowEachOther) {
  const std::string other = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)";
  std::string json = json_with(R"("accessors":[)", R"("accessors":[)" + other);
  const std::string parts = R"({"attributes":{"POSITION":1},"indices":2},)"
                            R"({"attributes":{"POSITION":0},"indices":2})";
  const std::string old = GltfText().parts;
  json.replace(json.find(old), old.size(), parts);
  const Mesh mesh = read_content("glb", glb(json, tetrahedron_buffer()));
  EXPECT_EQ(mesh.num_vertices(), 8);
  EXPECT_EQ(mesh.faces[4], (Face{4, 6, 5}));
}

TEST(Gltf, SparsePositionsAreReplaced) {
  const Mesh mesh = read_content(
      "glb", glb(json_with(R"("bufferView":0,"componentType":5126,"count":4,)",
                           R"("bufferView":0,"componentType":5126,"count":4,"sparse":{"count":1,)"
                           R"("indices":{"bufferView":1,"byteOffset":2,"componentType":5123},)"
                           R"("values":{"bufferView":0,"byteOffset":12}},)"),
                 tetrahedron_buffer()));
  // The second corner is 2.
  EXPECT_EQ(mesh.vertices[2], tetrahedron().vertices[1]);
  EXPECT_EQ(mesh.vertices[3], tetrahedron().vertices[3]);
}

TEST(Gltf, MalformedFilesAreRefused) {
  EXPECT_THAT(read_error("glb", "glTX" + glb(GltfText().json(), "").substr(4)),
              HasSubstr("not valid glTF"));
  EXPECT_THAT(read_error("gltf", "{"), HasSubstr("not valid glTF"));
  EXPECT_THAT(read_error("gltf", "[]"), HasSubstr("not valid glTF"));
  EXPECT_THAT(error_with(R"("version":"2.0")", R"("version":"1.0")"), HasSubstr("version '1.0'"));
  EXPECT_THAT(error_with(R"("mesh":0)", R"("mesh":7)"), HasSubstr("mesh 7 is out of range"));
  EXPECT_THAT(error_with(R"("indices":1)", R"("indices":9)"), HasSubstr("out of bounds"));
  EXPECT_THAT(error_with(R"("POSITION":0)", R"("NORMAL":0)"), HasSubstr("no positions"));
  EXPECT_THAT(error_with(R"("count":12)", R"("count":13)"), HasSubstr("do not fit"));
  EXPECT_THAT(error_with(R"("count":12)", R"("count":11)"), HasSubstr("do not make triangles"));
  EXPECT_THAT(error_with(R"("byteLength":48)", R"("byteLength":480)"), HasSubstr("buffer view 0"));
  EXPECT_THAT(error_with(R"("nodes":[{"mesh":0}])", R"("nodes":[{"children":[0]}])"),
              HasSubstr("two parents"));
  EXPECT_THAT(glb_error({.parts = R"({"attributes":{"POSITION":0},"mode":1})"}),
              HasSubstr("no triangles, only lines or points"));
}

TEST(Gltf, CompressionIsNamedAsTheReason) {
  for (const std::string name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
    EXPECT_THAT(glb_error({.more = R"(,"extensionsRequired":[")" + name + "\"]"}),
                HasSubstr("needs the extension " + name));
  EXPECT_EQ(read_glb({.more = R"(,"extensionsRequired":["KHR_texture_transform"])"}).faces,
            tetrahedron().faces);
}

/// Compressed attributes have accessors without data, and buffers that are not there.
TEST(Gltf, CompressionIsNamedBeforeTheHolesThatItLeaves) {
  const std::string holes =
      R"({"asset":{"version":"2.0"},"extensionsRequired":["EXT_meshopt_compression"],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
      R"("accessors":[{"componentType":5126,"count":4,"type":"VEC3"},{"count":3}],)"
      R"("bufferViews":[{"buffer":1}],"buffers":[{"extensions":{}}]})";
  EXPECT_THAT(read_error("glb", glb(holes, "1234")), HasSubstr("needs the extension EXT_meshopt"));
  EXPECT_THAT(read_error("gltf", holes), HasSubstr("needs the extension EXT_meshopt"));
  EXPECT_THAT(read_error("gltf", "\xEF\xBB\xBF" + holes), HasSubstr("EXT_meshopt"));
  EXPECT_THAT(read_error("glb", glb(holes, "").substr(0, 30)), HasSubstr("not valid glTF"));
}

TEST(Gltf, IndicesOutOfRangeAndHugeCountsAreRefused) {
  std::string buffer = tetrahedron_buffer();
  buffer[48] = 4;
  EXPECT_THAT(read_error("glb", glb(GltfText().json(), buffer)),
              HasSubstr("vertex index 4 is out of range"));
  EXPECT_THAT(error_with(R"("count":4,)", R"("count":4000000000,)"), HasSubstr("4000000000"));
  EXPECT_THAT(error_with(R"("bufferView":0,"componentType":5126,"count":4,)",
                         R"("componentType":5126,"count":4000000000,"sparse":{"count":1,)"
                         R"("indices":{"bufferView":1,"componentType":5123},)"
                         R"("values":{"bufferView":0}},)"),
              HasSubstr("4000000000"));
}

TEST(Gltf, MissingBuffersAreNamed) {
  const GltfText text{.uri = R"(,"uri":"nowhere.bin")"};
  EXPECT_THAT(read_error("gltf", text.json()), HasSubstr("nowhere.bin"));
}

TEST(Gltf, WhatDoesNotFitInto32BitsIsNotWritten) {
  const test::TemporaryFolder folder;
  Mesh mesh = tetrahedron();
  mesh.vertices[0].x() = 1e39;
  EXPECT_THROW(write_mesh(folder.path("a.glb"), mesh), BadFile);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace isomatch
