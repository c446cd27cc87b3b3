// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/model_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/io/mesh_io.h"
#include "support/random.h"
#include "support/rough_meshes.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"
#include "support/transforms.h"

namespace isomatch {
namespace {

using test::TemporaryFolder;

VertexColors byte_colors(int vertices) {
  test::Random random(4);
  VertexColors colors;
  for (int v = 0; v < vertices; ++v)
    colors.emplace_back(random.index(256) / 255.0, random.index(256) / 255.0,
                        random.index(256) / 255.0);
  return colors;
}

Model colored_soup() {
  const Mesh mesh = test::rounded_to_float(test::triangle_soup(200, 300, 3));
  Model model{mesh, byte_colors(200), {}, {{"grown", mesh.vertices}, {"still", mesh.vertices}}};
  for (Point& p : model.poses[0].vertices) p *= 3;
  return model;
}

/// A square of two faces that has different texture coordinates on both sides of its diagonal.
Model seamed_square() {
  Model model{test::sheet(1, 1), {}, {}, {}};
  model.texture.coordinates = {{0, 0}, {0.5, 0}, {0.5, 1}, {1, 0.25}, {0.75, 1}, {0, 0}};
  model.texture.corners = {{0, 1, 2}, {3, 4, 5}};
  model.texture.materials = {"fur"};
  model.texture.face_material = {0, 0};
  return model;
}

Eigen::Vector2d place(const Model& model, int face, int corner) {
  return model.texture.coordinates[model.texture.corners[face][corner]];
}

TEST(ModelIo, GltfKeepsColorsAndPoses) {
  const TemporaryFolder folder;
  const Model model = colored_soup();
  for (const char* name : {"a.glb", "a.gltf"}) {
    write_model(folder.path(name), model);
    const Model copy = read_model(folder.path(name));
    EXPECT_EQ(copy.mesh.vertices, model.mesh.vertices) << name;
    EXPECT_EQ(copy.mesh.faces, model.mesh.faces) << name;
    ASSERT_EQ(copy.poses.size(), 2U);
    EXPECT_EQ(copy.poses[0].name, "grown");
    EXPECT_EQ(copy.poses[1].name, "still");
    EXPECT_EQ(copy.poses[1].vertices, model.mesh.vertices);
    for (int v = 0; v < 200; ++v) {
      // Displacements are rounded to 32 bits, coordinates are below 3.
      EXPECT_LT((copy.poses[0].vertices[v] - model.poses[0].vertices[v]).norm(), 4e-7);
      EXPECT_LT((copy.colors[v] - model.colors[v]).norm(), 1e-6);
    }
  }
}

TEST(ModelIo, ColorsSurviveTheWayThroughGltfToTheByte) {
  const TemporaryFolder folder;
  const Model model = colored_soup();
  write_model(folder.path("a.ply"), model);
  write_model(folder.path("a.glb"), read_model(folder.path("a.ply")));
  write_model(folder.path("b.ply"), read_model(folder.path("a.glb")));
  EXPECT_TRUE(test::read_file(folder.path("a.ply")) == test::read_file(folder.path("b.ply")));
}

TEST(ModelIo, SeamsAddCopiesAfterTheVertices) {
  const TemporaryFolder folder;
  const Model model = seamed_square();
  write_model(folder.path("a.glb"), model);
  const Model copy = read_model(folder.path("a.glb"));
  // Of the diagonal's vertices, which are 0 and 3.
  ASSERT_EQ(copy.mesh.num_vertices(), 6);
  for (int v = 0; v < 4; ++v) EXPECT_EQ(copy.mesh.vertices[v], model.mesh.vertices[v]);
  for (int f = 0; f < 2; ++f) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(place(copy, f, k), place(model, f, k));
      EXPECT_EQ(copy.mesh.vertices[copy.mesh.faces[f][k]],
                model.mesh.vertices[model.mesh.faces[f][k]]);
    }
  }
}

TEST(ModelIo, EqualTextureCoordinatesNeedNoCopies) {
  const TemporaryFolder folder;
  Model model = seamed_square();
  for (int f = 0; f < 2; ++f)
    for (int k = 0; k < 3; ++k)
      model.texture.coordinates[3 * f + k] = model.mesh.vertices[model.mesh.faces[f][k]].head<2>();
  model.texture.corners = {{0, 1, 2}, {3, 4, 5}};
  write_model(folder.path("a.glb"), model);
  EXPECT_EQ(read_model(folder.path("a.glb")).mesh.faces, model.mesh.faces);
}

TEST(ModelIo, TexturesGoBetweenObjAndGltf) {
  const TemporaryFolder folder;
  write_model(folder.path("a.obj"), seamed_square());
  const Model read = read_model(folder.path("a.obj"));
  EXPECT_EQ(read.texture.materials, std::vector<std::string>{"fur"});
  write_model(folder.path("a.glb"), read);
  write_model(folder.path("b.obj"), read_model(folder.path("a.glb")));
  const Model back = read_model(folder.path("b.obj"));
  for (int f = 0; f < 2; ++f)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(place(back, f, k), place(read, f, k));
}

TEST(ModelIo, WhatAFormatHasNoRoomForIsLeftOut) {
  const TemporaryFolder folder;
  const Model model = colored_soup();
  for (const char* name : {"a.off", "a.obj", "a.mat"}) {
    write_model(folder.path(name), model);
    const Model copy = read_model(folder.path(name));
    EXPECT_EQ(copy.mesh.vertices, model.mesh.vertices);
    EXPECT_TRUE(copy.colors.empty() && copy.poses.empty() && copy.texture.corners.empty()) << name;
  }
}

TEST(ModelIo, SameModelSameBytes) {
  const TemporaryFolder folder;
  for (const char* name : {"a.glb", "b.glb"}) write_model(folder.path(name), colored_soup());
  EXPECT_TRUE(test::read_file(folder.path("a.glb")) == test::read_file(folder.path("b.glb")));
}

TEST(ModelIo, InvalidModelsAreRefusedAndLeaveNothing) {
  const TemporaryFolder folder;
  Model model = colored_soup();
  model.colors.pop_back();
  EXPECT_THROW(write_model(folder.path("a.glb"), model), InvalidInput);
  model = colored_soup();
  model.poses[1].vertices.pop_back();
  EXPECT_THROW(write_model(folder.path("a.glb"), model), InvalidInput);
  model = colored_soup();
  model.poses[1].vertices[3].x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(write_model(folder.path("a.glb"), model), BadFile);
  EXPECT_THROW(write_model(folder.path("a.stl"), colored_soup()), BadFile);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace isomatch
