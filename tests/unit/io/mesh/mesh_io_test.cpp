// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/mesh_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <locale>
#include <random>

#include "isomatch/error.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"
#include "support/transforms.h"

namespace isomatch {
namespace {

using test::read_file;
using test::TemporaryFolder;
using test::tetrahedron;

std::string message(const std::function<void()>& action) {
  try {
    action();
  } catch (const BadFile& error) {
    return error.what();
  }
  return "no error";
}

/// Doubles of every magnitude: any finite bit pattern.
Mesh wild_mesh() {
  std::mt19937_64 random(3);
  const auto number = [&] {
    for (;;) {
      const auto value = std::bit_cast<double>(random());
      if (std::isfinite(value)) return value;
    }
  };
  Mesh mesh;
  for (int v = 0; v < 500; ++v) mesh.vertices.emplace_back(number(), number(), number());
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max();
  mesh.vertices.emplace_back(-0.0, 0.0, -least);
  mesh.vertices.emplace_back(most, -most, std::numeric_limits<double>::min());
  mesh.vertices.emplace_back(0.1, 1.0 / 3.0, -1e22);
  for (int f = 0; f < 900; ++f)
    mesh.faces.push_back({static_cast<int>(random() % 503), static_cast<int>(random() % 503),
                          static_cast<int>(random() % 503)});
  return mesh;
}

bool same_bits(const std::vector<Point>& a, const std::vector<Point>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0;
}

TEST(MeshIo, CoordinatesThatAreNoNumbersAreKept) {
  const TemporaryFolder folder;
  Mesh mesh = tetrahedron();
  mesh.vertices[1].y() = std::numeric_limits<double>::quiet_NaN();
  mesh.vertices[2].z() = -std::numeric_limits<double>::infinity();
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.mat"}) {
    write_mesh(folder.path(name), mesh);
    const Mesh copy = read_mesh(folder.path(name));
    EXPECT_EQ(copy.num_faces(), mesh.num_faces()) << name;
    const auto is_infinite = [](const Point& p) { return std::isinf(p.z()); };
    const auto is_no_number = [](const Point& p) { return std::isnan(p.y()); };
    EXPECT_TRUE(std::ranges::any_of(copy.vertices, is_infinite)) << name;
    EXPECT_TRUE(std::ranges::any_of(copy.vertices, is_no_number)) << name;
  }
}

TEST(MeshIo, RoundTripsAreExact) {
  const TemporaryFolder folder;
  const Mesh mesh = wild_mesh();
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.mat"}) {
    write_mesh(folder.path(name), mesh);
    MeshReadReport report{7, 7, {}, {}};
    const Mesh copy = read_mesh(folder.path(name), &report);
    EXPECT_TRUE(same_bits(copy.vertices, mesh.vertices)) << name;
    EXPECT_EQ(copy.faces, mesh.faces) << name;
    EXPECT_EQ(report.triangulated_polygons, 0);
    EXPECT_EQ(report.merged_vertices, 0);
  }
}

TEST(MeshIo, GltfRoundsCoordinatesAndKeepsTheRest) {
  const TemporaryFolder folder;
  Mesh mesh = wild_mesh();
  for (Point& p : mesh.vertices)
    for (double& c : p)
      if (std::abs(c) > std::numeric_limits<float>::max()) c = std::copysign(0.1, c);
  const Mesh rounded = test::rounded_to_float(mesh);
  for (const char* name : {"a.glb", "a.gltf"}) {
    write_mesh(folder.path(name), mesh);
    const Mesh copy = read_mesh(folder.path(name));
    EXPECT_TRUE(same_bits(copy.vertices, rounded.vertices)) << name;
    EXPECT_EQ(copy.faces, mesh.faces) << name;
  }
}

TEST(MeshIo, WritesTheFormatsAsDocumented) {
  const TemporaryFolder folder;
  const Mesh triangle = {{Point(0, -0.0, 0.1), Point(1e-300, 2, 3), Point(-4, 5, 6e22)},
                         {{2, 0, 1}}};
  write_mesh(folder.path("a.off"), triangle);
  EXPECT_EQ(read_file(folder.path("a.off")),
            "OFF\n3 1 0\n0 -0 0.1\n1e-300 2 3\n-4 5 6e+22\n3 2 0 1\n");
  write_mesh(folder.path("a.obj"), triangle);
  EXPECT_EQ(read_file(folder.path("a.obj")), "v 0 -0 0.1\nv 1e-300 2 3\nv -4 5 6e+22\nf 3 1 2\n");
  write_mesh(folder.path("a.ply"), triangle);
  EXPECT_EQ(
      read_file(folder.path("a.ply")),
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\n"
      "property double y\nproperty double z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n" +
          test::bytes<double>(std::endian::little, {0, -0.0, 0.1, 1e-300, 2, 3, -4, 5, 6e22}) +
          "\x03" + test::bytes<std::int32_t>(std::endian::little, {2, 0, 1}));
}

TEST(MeshIo, EndingsMayBeInUpperCase) {
  const TemporaryFolder folder;
  write_mesh(folder.path("a.OFF"), tetrahedron());
  write_mesh(folder.path("a.b.Ply"), tetrahedron());
  EXPECT_EQ(read_file(folder.path("a.OFF")).substr(0, 3), "OFF");
  EXPECT_EQ(read_file(folder.path("a.b.Ply")).substr(0, 3), "ply");
  EXPECT_EQ(read_mesh(folder.path("a.OFF")).faces, tetrahedron().faces);
  EXPECT_EQ(read_mesh(folder.path("a.b.Ply")).faces, tetrahedron().faces);
}

TEST(MeshIo, NumbersDoNotDependOnTheLocale) {
  struct Commas : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale old = std::locale::global(std::locale(std::locale(), new Commas));
  const TemporaryFolder folder;
  Mesh mesh = tetrahedron();
  mesh.vertices[0] = Point(1234567.5, 0, 0);
  for (const char* name : {"a.off", "a.glb", "a.gltf"}) {
    write_mesh(folder.path(name), mesh);
    EXPECT_EQ(read_mesh(folder.path(name)).vertices, mesh.vertices) << name;
  }
  std::locale::global(old);
}

TEST(MeshIo, NamesFilesThatCannotBeRead) {
  const TemporaryFolder folder;
  const auto error = [](const std::string& path) { return message([&] { read_mesh(path); }); };
  const std::string missing = folder.path("missing.off");
  EXPECT_EQ(error(missing), missing + ": No such file or directory");
  const std::string empty = folder.write("empty.ply", "");
  EXPECT_EQ(error(empty), empty + ": the file is empty");
  const std::string unknown = folder.write("mesh.3ds", "M");
  EXPECT_EQ(error(unknown),
            unknown +
                ": the ending '.3ds' is not that of a mesh file: .off .obj .ply .glb .gltf .mat "
                ".stl");
  const std::string bare = folder.write("off", "OFF");
  EXPECT_EQ(error(bare),
            bare +
                ": the ending '' is not that of a mesh file: .off .obj .ply .glb .gltf .mat "
                ".stl");
  const std::string directory = folder.path("folder.off");
  std::filesystem::create_directory(directory);
  EXPECT_EQ(error(directory), directory + ": is a folder");
}

TEST(MeshIo, DoesNotWaitForAPipe) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe.off");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(message([&] { read_mesh(pipe); }), pipe + ": not a regular file");
}

TEST(MeshIo, FailedWritesLeaveNothing) {
  const TemporaryFolder folder;
  Mesh bad = tetrahedron();
  bad.faces[0][0] = 4;
  EXPECT_THROW(write_mesh(folder.path("a.off"), bad), InvalidInput);
  EXPECT_THROW(write_mesh(folder.path("a.ply"), Mesh{}), InvalidInput);
  EXPECT_THROW(write_mesh(folder.path("a.txt"), tetrahedron()), BadFile);
  EXPECT_EQ(message([&] { write_mesh(folder.path("a.stl"), tetrahedron()); }),
            folder.path("a.stl") +
                ": STL files are only read; write .off, .obj, .ply, .glb, .gltf or .mat");
  EXPECT_THAT(folder.names(), testing::IsEmpty());
}

TEST(MeshIo, WritesTheSameBytesEveryTime) {
  const TemporaryFolder folder;
  for (const char* ending : {".off", ".obj", ".ply"}) {
    write_mesh(folder.path(std::string("a") + ending), wild_mesh());
    write_mesh(folder.path(std::string("b") + ending), wild_mesh());
    EXPECT_EQ(read_file(folder.path(std::string("a") + ending)),
              read_file(folder.path(std::string("b") + ending)));
  }
}

}  // namespace
}  // namespace isomatch
