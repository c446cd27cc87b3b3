// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>
#include <utility>
#include <vector>

#include "isomatch/io/model_io.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

using test::read_content;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Corners = std::vector<Point>;

std::string vertex_lines(const Corners& corners, const std::string& start) {
  std::string text;
  for (const Point& p : corners) text += fmt::format("{}{} {} {}\n", start, p.x(), p.y(), p.z());
  return text;
}

std::string indices(std::size_t count, int begin, int first) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k) text += fmt::format(" {}", (k + begin) % count + first);
  return text;
}

/// One polygon as a file, whose face begins with corner number `begin`.
std::string off(const Corners& corners, int begin) {
  return fmt::format("OFF\n{} 1 0\n{}{}{}\n", corners.size(), vertex_lines(corners, ""),
                     corners.size(), indices(corners.size(), begin, 0));
}
std::string obj(const Corners& corners, int begin) {
  return vertex_lines(corners, "v ") + "f" + indices(corners.size(), begin, 1) + "\n";
}
std::string ply(const Corners& corners, int begin) {
  return fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list int int "
      "vertex_indices\nend_header\n{}{}{}\n",
      corners.size(), vertex_lines(corners, ""), corners.size(), indices(corners.size(), begin, 0));
}

/// The vector area, whose length is less than the area if faces are folded back.
double oriented_area(const Mesh& mesh) {
  Point sum = Point::Zero();
  for (const auto& [a, b, c] : mesh.faces)
    sum += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]) / 2;
  return sum.norm();
}

const Corners kU = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0},
                    {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
const Corners kArrow = {{0, 0, 0}, {4, 1, 0}, {0, 2, 0}, {1, 1, 0}};

TEST(Polygons, ConcaveOnesHaveTheirAreaWhereverTheyBegin) {
  for (const auto& [corners, area] : {std::pair{kU, 7.0}, {kArrow, 3.0}}) {
    for (int begin = 0; begin < std::ssize(corners); ++begin) {
      for (const Mesh& mesh :
           {read_content("off", off(corners, begin)), read_content("obj", obj(corners, begin)),
            read_content("ply", ply(corners, begin))}) {
        EXPECT_EQ(mesh.vertices, corners);
        EXPECT_EQ(mesh.faces.size(), corners.size() - 2);
        EXPECT_NEAR(surface_area(mesh), area, 1e-12) << begin;
        EXPECT_NEAR(oriented_area(mesh), area, 1e-12) << begin;
        const auto& [a, b, c] = mesh.faces[0];
        EXPECT_GT(
            (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).z(),
            0);
      }
    }
  }
}

TEST(Polygons, AConcavePolygonThatIsNotFlatHasOneAreaToo) {
  Corners bent = kU;
  for (Point& p : bent) p.z() = 0.3 * p.x() * p.x() - 0.2 * p.y();
  const double area = surface_area(read_content("off", off(bent, 0)));
  for (int begin = 1; begin < 8; ++begin)
    EXPECT_NEAR(surface_area(read_content("off", off(bent, begin))), area, 1e-12);
}

TEST(Polygons, ConvexOnesStayFansAroundTheirFirstCorner) {
  const Corners square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0}};
  EXPECT_THAT(read_content("off", off(square, 1)).faces, ElementsAre(Face{1, 2, 3}, Face{1, 3, 0}));
  // With a straight corner, which rounding makes concave by a hair.
  const Corners house = {{0, 0, 0}, {0.5, 1e-9, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_THAT(read_content("off", off(house, 2)).faces,
              ElementsAre(Face{2, 3, 4}, Face{2, 4, 0}, Face{2, 0, 1}));
}

TEST(Polygons, AConcaveQuadWhoseFirstDiagonalIsInsideStaysAsItIs) {
  EXPECT_THAT(read_content("off", off(kArrow, 1)).faces, ElementsAre(Face{1, 2, 3}, Face{1, 3, 0}));
  EXPECT_THAT(read_content("off", off(kArrow, 0)).faces, ElementsAre(Face{1, 2, 3}, Face{1, 3, 0}));
}

TEST(Polygons, HugeAndTinyOnesAreCutToo) {
  for (const double scale : {1e-200, 1e-6, 1e6, 1e100}) {
    Corners corners = kU;
    for (Point& p : corners) p *= scale;
    EXPECT_EQ(read_content("off", off(corners, 0)).faces, read_content("off", off(kU, 0)).faces);
  }
}

TEST(Polygons, AHoleThatABridgeLeadsToStaysEmpty) {
  const Corners corners = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                           {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}};
  const std::string text = "OFF\n8 1 0\n" + vertex_lines(corners, "") + "10 0 1 2 3 0 4 5 6 7 4\n";
  MeshReadReport report;
  const Mesh mesh = read_content("off", text, &report);
  EXPECT_NEAR(surface_area(mesh), 12, 1e-12);
  EXPECT_NEAR(oriented_area(mesh), 12, 1e-12);
  EXPECT_THAT(report.warnings, IsEmpty());
}

TEST(Polygons, ThoseThatIntersectThemselvesAreWarnedOf) {
  const Corners star = {{0, 3, 0}, {2, -2, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -2, 0}};
  const Corners crossed = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {3, 2, 0}, {1, -1, 0}, {-1, 3, 0}};
  for (const Corners& corners : {star, crossed}) {
    MeshReadReport report;
    const Mesh mesh = read_content("off", off(corners, 0), &report);
    EXPECT_EQ(mesh.faces[1], (Face{0, 2, 3}));
    EXPECT_EQ(mesh.vertices, corners);
    EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("intersect themselves")));
  }
}

TEST(Polygons, WithoutAreaTheyStayFans) {
  const Corners line = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1.5, 1.5, 1.5}};
  const Corners point = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  for (const Corners& corners : {line, point}) {
    MeshReadReport report;
    EXPECT_EQ(read_content("off", off(corners, 0), &report).faces[1], (Face{0, 2, 3}));
    EXPECT_THAT(report.warnings, IsEmpty());
  }
}

TEST(Polygons, FacesOfTwoCornersArePassedOverAndCounted) {
  MeshReadReport report;
  const Mesh from_off =
      read_content("off", "OFF\n3 4 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n1 2\n0\n", &report);
  EXPECT_THAT(from_off.faces, ElementsAre(Face{0, 1, 2}));
  EXPECT_THAT(report.warnings, ElementsAre("faces of fewer than three corners, left out: 3"));
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1\nf 1/1 2/1 3/1\nf\n";
  EXPECT_THAT(read_content("obj", text, &report).faces, ElementsAre(Face{0, 1, 2}));
  EXPECT_THAT(report.warnings, ElementsAre("faces of fewer than three corners, left out: 2"));
  const test::TemporaryFolder folder;
  EXPECT_EQ(read_model(folder.write("a.obj", text)).texture.corners.size(), 1U);
}

TEST(Polygons, TextureAndMaterialFollow) {
  std::string text = vertex_lines(kU, "v ") + "v 9 9 9\n";
  for (const Point& p : kU) text += fmt::format("vt {} {}\n", p.x(), p.y());
  text += "usemtl a\nf 1/1 2/2 9/3\nusemtl b\nf";
  for (int k = 0; k < 8; ++k) text += fmt::format(" {0}/{0}", (k + 2) % 8 + 1);
  text += "\nusemtl c\nf 1/1 2/2 9/3\n";
  const test::TemporaryFolder folder;
  const Model model = read_model(folder.write("a.obj", text));
  ASSERT_EQ(model.mesh.num_faces(), 8);
  EXPECT_THAT(model.texture.face_material, ElementsAre(0, 1, 1, 1, 1, 1, 1, 2));
  for (int f = 1; f < 7; ++f)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(model.texture.coordinates[model.texture.corners[f][k]],
                Eigen::Vector2d(model.mesh.vertices[model.mesh.faces[f][k]].head<2>()));
}

/// A comb, whose teeth all reach across whatever line sweeps over it.
TEST(Polygons, TenThousandCornersTakeNoTime) {
  Corners comb = {{0, -1, 0}, {5000, -1, 0}};
  for (int k = 4999; k > 0; --k) comb.emplace_back(k, k % 2 == 0 ? 0 : 100, 0);
  comb.emplace_back(0, 0, 0);
  Corners turned = comb;
  for (Point& p : turned) p = {-p.y(), p.x(), 0};
  for (const Corners& corners : {comb, turned}) {
    const Mesh mesh = read_content("off", off(corners, 17));
    EXPECT_EQ(mesh.faces.size(), corners.size() - 2);
    EXPECT_NEAR(surface_area(mesh), oriented_area(mesh), 1e-6);
  }
}

}  // namespace
}  // namespace isomatch
