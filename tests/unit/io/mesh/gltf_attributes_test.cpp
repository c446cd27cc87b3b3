// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>

#include "isomatch/io/model_io.h"
#include "support/gltf_files.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

using test::bytes;
using test::GltfText;
using test::tetrahedron_buffer;
using Corner = Eigen::Vector2d;

Model read(GltfText text, const std::string& more_bytes) {
  const test::TemporaryFolder folder;
  const std::string buffer = tetrahedron_buffer() + more_bytes;
  text.bytes = buffer.size();
  return read_model(folder.write("a.glb", test::glb(text.json(), buffer)));
}

std::string floats(std::initializer_list<float> values) {
  return bytes<float>(std::endian::little, values);
}

Corner corner(const Model& model, int face, int k) {
  return model.texture.coordinates[model.texture.corners[face][k]];
}

/// Four vertices with texture coordinates, which a material moves by `transform`.
Model textured(const std::string& transform, const std::string& type, const std::string& data,
               const std::string& set = "TEXCOORD_0", const std::string& use = "") {
  return read(
      {.parts = R"({"attributes":{"POSITION":0,")" + set + R"(":2},"indices":1,"material":0})",
       .more = R"(,"images":[{"uri":"a.png"}],"textures":[{"source":0}],"materials":[{)"
               R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0)" +
               use + R"(,"extensions":{"KHR_texture_transform":{)" + transform + "}}}}}]",
       .accessors = R"(,{"bufferView":2,"count":4,"type":"VEC2",)" + type + "}",
       .views =
           R"(,{"buffer":0,"byteOffset":72,"byteLength":)" + std::to_string(data.size()) + "}"},
      data);
}

constexpr const char* kFloat = R"("componentType":5126)";
/// The first vertex, whose place is in question, and three others; v down.
const std::string kPlaces = floats({0.25F, 0.5F, 0, 0, 1, 0, 0, 1});

/// The place of vertex 0, v up.
Corner place_of_first(const Model& model) {
  for (int f = 0; f < model.mesh.num_faces(); ++f)
    for (int k = 0; k < 3; ++k)
      if (model.mesh.faces[f][k] == 0) return corner(model, f, k);
  return {-1, -1};
}

TEST(GltfTextureTransform, OffsetScaleAndRotationMoveTextureCoordinates) {
  EXPECT_EQ(place_of_first(textured("", kFloat, kPlaces)), Corner(0.25, 0.5));
  EXPECT_EQ(place_of_first(textured(R"("offset":[1,0.25])", kFloat, kPlaces)), Corner(1.25, 0.25));
  EXPECT_EQ(place_of_first(textured(R"("scale":[2,0.5])", kFloat, kPlaces)), Corner(0.5, 0.75));
  // The specification's example: the lower left quarter of the image, turned clockwise.
  const Model turned = textured(R"("offset":[0,1],"rotation":1.5707963267948966,"scale":[0.5,0.5])",
                                kFloat, kPlaces);
  for (const Corner& place : turned.texture.coordinates) {
    EXPECT_GE(place.minCoeff(), -1e-12);
    EXPECT_LE(place.maxCoeff(), 0.5 + 1e-12);
  }
  EXPECT_LT((place_of_first(turned) - Corner(0.25, 0.125)).norm(), 1e-12);
}

TEST(GltfTextureTransform, QuantisedCoordinatesAreUnpacked) {
  const std::string packed =
      bytes<std::uint16_t>(std::endian::little, {1024, 2048, 0, 0, 4095, 0, 0, 4095});
  const std::string unpack = R"("offset":[0,0],"scale":[0.00024420024420024420,0.0002442002442])";
  const Corner plain = place_of_first(textured(unpack, R"("componentType":5123)", packed));
  EXPECT_NEAR(plain.x(), 1024 / 4095.0, 1e-9);
  EXPECT_NEAR(plain.y(), 1 - 2048 / 4095.0, 1e-9);
  const std::string wider = R"("scale":[16.003663003663,16.003663003663])";
  const Corner normalised =
      place_of_first(textured(wider, R"("componentType":5123,"normalized":true)", packed));
  EXPECT_NEAR(normalised.x(), 1024 / 4095.0, 1e-9);
}

TEST(GltfTextureTransform, TheSetOfCoordinatesIsTheMaterials) {
  const Corner named =
      place_of_first(textured("", kFloat, kPlaces, "TEXCOORD_1", R"(,"texCoord":1)"));
  EXPECT_EQ(named, Corner(0.25, 0.5));
  const Corner overridden = place_of_first(
      textured(R"("texCoord":2)", kFloat, kPlaces, "TEXCOORD_2", R"(,"texCoord":1)"));
  EXPECT_EQ(overridden, Corner(0.25, 0.5));
}

/// Two parts of the same positions: the first with the faces of the first vertex alone.
GltfText shared_positions(const std::string& first, const std::string& second) {
  const std::string views = R"(,{"buffer":0,"byteOffset":72,"byteLength":32},)"
                            R"({"buffer":0,"byteOffset":104,"byteLength":32},)"
                            R"({"buffer":0,"byteOffset":136,"byteLength":48})";
  const std::string face = R"(,{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},)"
                           R"({"bufferView":1,"byteOffset":18,"componentType":5123,"count":3,)"
                           R"("type":"SCALAR"},)";
  const std::string values = R"({"bufferView":2,"componentType":5126,"count":4,"type":"VEC2"},)"
                             R"({"bufferView":3,"componentType":5126,"count":4,"type":"VEC2"},)"
                             R"({"bufferView":4,"componentType":5126,"count":4,"type":"VEC3"})";
  return {.parts = R"({"attributes":{"POSITION":0,)" + first +
                   R"(},"indices":2},)"
                   R"({"attributes":{"POSITION":0,)" +
                   second + R"(},"indices":3})",
          .accessors = face + values,
          .views = views};
}

const std::string kSharedBytes = floats({0, 0, 0, 0, 0, 0, 0, 0}) +
                                 floats({1, 0, 1, 0, 1, 0, 1, 0}) +
                                 floats({1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0});

TEST(GltfAttributes, PartsThatSharePositionsKeepTheirTextureCoordinates) {
  const Model model =
      read(shared_positions(R"("TEXCOORD_0":4)", R"("TEXCOORD_0":5)"), kSharedBytes);
  EXPECT_EQ(model.mesh.num_vertices(), 4);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(corner(model, 0, k), Corner(0, 1));
    EXPECT_EQ(corner(model, 1, k), Corner(1, 1));
  }
}

TEST(GltfAttributes, TheSecondPartColoursTheVerticesThatItAloneUses) {
  const Model model = read(shared_positions(R"("TEXCOORD_0":4)", R"("COLOR_0":6)"), kSharedBytes);
  ASSERT_EQ(model.colors.size(), 4U);
  int red = 0;
  for (int v = 0; v < 4; ++v) {
    const auto has = [&](int face) { return std::ranges::count(model.mesh.faces[face], v) > 0; };
    const bool is_red = model.colors[v].isApprox(Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(is_red, has(1) && !has(0));
    EXPECT_TRUE(is_red || model.colors[v].isApprox(Eigen::Vector3d(1, 1, 1)));
    red += is_red;
  }
  EXPECT_EQ(red, 1);
  EXPECT_FALSE(model.texture.covers(1));
}

TEST(GltfAttributes, PosesOfOneNameAreOneAndOthersKeepStill) {
  const std::string target =
      R"({"attributes":{"POSITION":0},"indices":1,"targets":[{"POSITION":2}]})";
  const std::string smile = R"("extras":{"targetNames":["smile"]},"primitives":[)" + target + "]";
  const Model model = read(
      {.scenes = R"({"nodes":[0,1,2]})",
       .nodes = R"({"mesh":0},{"mesh":1},{"mesh":2,"scale":[2,2,2]})",
       .meshes = "{" + smile + R"(},{"primitives":[)" + GltfText().parts + "]},{" + smile + "}",
       .accessors = R"(,{"bufferView":2,"componentType":5126,"count":4,)"
                    R"("type":"VEC3"})",
       .views = R"(,{"buffer":0,"byteOffset":72,"byteLength":48})"},
      floats({1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}));
  ASSERT_EQ(model.poses.size(), 1U);
  EXPECT_EQ(model.poses[0].name, "smile");
  const auto moved = [&](int v) {
    return Point(model.poses[0].vertices[v] - model.mesh.vertices[v]);
  };
  EXPECT_EQ(moved(1), Point(1, 0, 0));
  EXPECT_EQ(moved(5), Point(0, 0, 0));
  EXPECT_EQ(moved(9), Point(2, 0, 0));
}

}  // namespace
}  // namespace isomatch
