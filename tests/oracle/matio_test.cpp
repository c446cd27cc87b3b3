// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>
#include <matio.h>

#include <array>
#include <memory>
#include <vector>

#include "isomatch/io/mesh_io.h"
#include "support/rough_meshes.h"
#include "support/temporary_folder.h"

/// .mat files against libmatio, in both directions.
namespace isomatch {
namespace {

struct Close {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using File = std::unique_ptr<mat_t, Close>;
using Variable = std::unique_ptr<matvar_t, Close>;

constexpr std::array<const char*, 4> kFields = {"X", "Y", "Z", "TRIV"};

/// The fields of a shape, column by column.
std::array<std::vector<double>, 4> columns(const Mesh& mesh) {
  std::array<std::vector<double>, 4> result;
  for (int k = 0; k < 3; ++k) {
    for (const Point& p : mesh.vertices) result[k].push_back(p[k]);
    for (const Face& face : mesh.faces) result[3].push_back(face[k] + 1);
  }
  return result;
}

void write_with_matio(const std::string& path, const Mesh& mesh, matio_compression compression) {
  const File file(Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5));
  std::array<std::size_t, 2> one = {1, 1};
  std::array<const char*, 4> names = kFields;
  const Variable surface(Mat_VarCreateStruct("surface", 2, one.data(), names.data(), 4));
  auto values = columns(mesh);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t width = k == 3 ? 3 : 1;
    std::array<std::size_t, 2> size = {values[k].size() / width, width};
    // The struct frees it.
    Mat_VarSetStructFieldByName(
        surface.get(), kFields[k], 0,
        Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(), values[k].data(), 0));
  }
  ASSERT_EQ(Mat_VarWrite(file.get(), surface.get(), compression), 0);
}

TEST(Matio, WhatItWritesIsRead) {
  const test::TemporaryFolder folder;
  const Mesh mesh = test::triangle_soup(100, 150, 2);
  for (const auto compression : {MAT_COMPRESSION_NONE, MAT_COMPRESSION_ZLIB}) {
    write_with_matio(folder.path("a.mat"), mesh, compression);
    const Mesh copy = read_mesh(folder.path("a.mat"));
    EXPECT_EQ(copy.vertices, mesh.vertices);
    EXPECT_EQ(copy.faces, mesh.faces);
  }
}

TEST(Matio, ReadsWhatIsWritten) {
  const test::TemporaryFolder folder;
  const Mesh mesh = test::triangle_soup(100, 150, 2);
  write_mesh(folder.path("a.mat"), mesh);
  const File file(Mat_Open(folder.path("a.mat").c_str(), MAT_ACC_RDONLY));
  ASSERT_TRUE(file);
  const Variable surface(Mat_VarRead(file.get(), "surface"));
  ASSERT_TRUE(surface);
  const auto values = columns(mesh);
  for (std::size_t k = 0; k < 4; ++k) {
    const matvar_t* field = Mat_VarGetStructFieldByName(surface.get(), kFields[k], 0);
    ASSERT_TRUE(field);
    const std::size_t count = field->dims[0] * field->dims[1];
    const auto* data = static_cast<const double*>(field->data);
    EXPECT_EQ(std::vector(data, data + count), values[k]) << kFields[k];
  }
}

}  // namespace
}  // namespace isomatch
