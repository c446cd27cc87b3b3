// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "isomatch/carry/texture_transfer.h"
#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "support/maps.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

using testing::Each;

/// The sheet's own coordinates, in one piece.
Texture flat_texture(const Mesh& sheet) {
  Texture texture;
  for (const Point& p : sheet.vertices) texture.coordinates.emplace_back(p.x(), p.y());
  texture.corners = sheet.faces;
  texture.face_material.assign(sheet.faces.size(), 0);
  texture.materials = {"paint"};
  return texture;
}

/// Angle over height around a cylinder about the z axis, with a seam at angle 0.
Texture wrapped_texture(const Mesh& cylinder) {
  Texture texture;
  for (const Face& face : cylinder.faces) {
    Point centre(0, 0, 0);
    for (int v : face) centre += cylinder.vertices[v] / 3;
    const auto turn = [](const Point& p) {
      const double angle = std::atan2(p.y(), p.x()) / (2 * std::numbers::pi);
      return angle < -1e-9 ? angle + 1 : angle;
    };
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      const Point& p = cylinder.vertices[face[k]];
      double u = turn(p);
      // At the seam 0 and 1 are one.
      if (u - turn(centre) > 0.5) u -= 1;
      if (turn(centre) - u > 0.5) u += 1;
      corners[k] = static_cast<int>(texture.coordinates.size());
      texture.coordinates.emplace_back(u, p.z());
    }
    texture.corners.push_back(corners);
  }
  texture.face_material.assign(cylinder.faces.size(), 0);
  texture.materials = {"bark"};
  return texture;
}

Eigen::Vector2d corner(const Texture& texture, int face, int k) {
  return texture.coordinates[texture.corners[face][k]];
}

TEST(TransferTexture, ByTheIdentityIsTheSame) {
  const Mesh mesh = test::open_cylinder(12, 5);
  const Texture texture = wrapped_texture(mesh);
  const TexturedMesh carried = transfer_texture(mesh, texture, mesh, test::identity_map(mesh));
  EXPECT_EQ(carried.mesh.vertices, mesh.vertices);
  EXPECT_EQ(carried.mesh.faces, mesh.faces);
  EXPECT_EQ(carried.texture.materials, texture.materials);
  EXPECT_THAT(carried.texture.face_material, Each(0));
  for (int f = 0; f < mesh.num_faces(); ++f)
    for (int k = 0; k < 3; ++k)
      EXPECT_LT((corner(carried.texture, f, k) - corner(texture, f, k)).norm(), 1e-9);
  // 13 x 6 and no more: what faces share is one, but for the seam.
  EXPECT_EQ(carried.texture.coordinates.size(), 13U * 6U);
}

/// A sheet's coordinates are positions, so those of any other mesh of it must be too.
TEST(TransferTexture, IsExactOnAnotherMesh) {
  const Mesh source = test::sheet(5, 5), target = test::sheet(7, 4);
  SurfaceMap map;
  for (const Point& p : target.vertices) {
    const int column = std::min(4, static_cast<int>(5 * p.x() + 1e-9));
    const int row = std::min(4, static_cast<int>(5 * p.y() + 1e-9));
    for (int face : {2 * (5 * row + column), 2 * (5 * row + column) + 1}) {
      const auto& [a, b, c] = source.faces[face];
      Eigen::Matrix3d corners;
      corners << source.vertices[a], source.vertices[b], source.vertices[c];
      corners.row(2).setOnes();
      const Point weights = corners.inverse() * Point(p.x(), p.y(), 1);
      if (weights.minCoeff() < -1e-9) continue;
      map.push_back({face, {weights[0], weights[1], weights[2]}});
      break;
    }
  }
  ASSERT_EQ(map.size(), target.vertices.size());
  const TexturedMesh carried = transfer_texture(source, flat_texture(source), target, map);
  ASSERT_EQ(carried.mesh.faces, target.faces);
  for (int f = 0; f < target.num_faces(); ++f)
    for (int k = 0; k < 3; ++k)
      EXPECT_LT(
          (corner(carried.texture, f, k) - target.vertices[target.faces[f][k]].head<2>()).norm(),
          1e-9);
}

/// A target cylinder turned by half a cell against the source: its faces straddle the seam.
class TurnedCylinder : public testing::Test {
 protected:
  static constexpr int kSegments = 16, kRings = 6;

  void SetUp() override {
    for (int v = 0; v < source_.num_vertices(); ++v) map_.push_back(half_way_on(v));
    for (int v = 0; v < target_.num_vertices(); ++v)
      target_.vertices[v] = position(source_, map_[v]);
  }

  /// The middle of the edge that leads on from `vertex` around the cylinder.
  SurfacePoint half_way_on(int vertex) const {
    const Point& p = source_.vertices[vertex];
    for (int f = 0; f < source_.num_faces(); ++f) {
      const Face& face = source_.faces[f];
      for (const auto& [k, j] : {std::pair{0, 1}, {1, 2}, {2, 0}, {1, 0}, {2, 1}, {0, 2}}) {
        const Point& q = source_.vertices[face[j]];
        if (face[k] != vertex || std::abs(q.z() - p.z()) > 1e-9 || p.cross(q).z() <= 0) continue;
        SurfacePoint point{f, {}};
        point.weights[k] = point.weights[j] = 0.5;
        return point;
      }
    }
    ADD_FAILURE() << "vertex " << vertex << " is not on a ring";
    return {};
  }

  /// How wide the triangle is in the texture.
  static double width(const Texture& texture, int face) {
    double low = 2, high = -2;
    for (int k = 0; k < 3; ++k) {
      low = std::min(low, corner(texture, face, k).x());
      high = std::max(high, corner(texture, face, k).x());
    }
    return high - low;
  }

  const Mesh source_ = test::open_cylinder(kSegments, kRings);
  const Texture texture_ = wrapped_texture(source_);
  Mesh target_ = source_;
  SurfaceMap map_;
};

TEST_F(TurnedCylinder, NoFaceReachesAcrossTheSeam) {
  for (const bool cut : {true, false}) {
    const TexturedMesh carried =
        transfer_texture(source_, texture_, target_, map_, {.cut_seams = cut});
    for (int f = 0; f < carried.mesh.num_faces(); ++f) {
      ASSERT_TRUE(carried.texture.covers(f));
      EXPECT_LT(width(carried.texture, f), 1.0 / kSegments + 1e-6);
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(corner(carried.texture, f, k).x(), 0);
        EXPECT_LE(corner(carried.texture, f, k).x(), 1);
      }
    }
  }
}

TEST_F(TurnedCylinder, CutFacesAreCoveredExactly) {
  const TexturedMesh carried = transfer_texture(source_, texture_, target_, map_);
  EXPECT_GT(carried.mesh.num_vertices(), target_.num_vertices());
  EXPECT_NEAR(surface_area(carried.mesh), surface_area(target_), 1e-9);
  for (int v = 0; v < target_.num_vertices(); ++v)
    EXPECT_EQ(carried.mesh.vertices[v], target_.vertices[v]);
  // Area in the texture, angle over height, is that of all of it.
  double area = 0;
  for (int f = 0; f < carried.mesh.num_faces(); ++f) {
    const Eigen::Vector2d u = corner(carried.texture, f, 1) - corner(carried.texture, f, 0);
    const Eigen::Vector2d w = corner(carried.texture, f, 2) - corner(carried.texture, f, 0);
    area += std::abs(u.x() * w.y() - u.y() * w.x()) / 2;
  }
  EXPECT_NEAR(area, 2, 1e-6);
}

TEST_F(TurnedCylinder, UncutFacesKeepTheMesh) {
  const TexturedMesh carried =
      transfer_texture(source_, texture_, target_, map_, {.cut_seams = false});
  EXPECT_EQ(carried.mesh.faces, target_.faces);
  EXPECT_EQ(carried.mesh.vertices, target_.vertices);
}

TEST(TransferTexture, SidesOfACubeKeepToThemselves) {
  const Mesh mesh = test::box(4);
  Texture texture;
  texture.materials = {"x", "-x", "y", "-y", "z", "-z"};
  for (const Face& face : mesh.faces) {
    const auto& p = mesh.vertices;
    const Point normal = (p[face[1]] - p[face[0]]).cross(p[face[2]] - p[face[0]]);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      corners[k] = static_cast<int>(texture.coordinates.size());
      texture.coordinates.emplace_back(p[face[k]][(axis + 1) % 3], p[face[k]][(axis + 2) % 3]);
    }
    texture.corners.push_back(corners);
    texture.face_material.push_back(2 * axis + (normal[axis] > 0 ? 0 : 1));
  }
  const TexturedMesh carried = transfer_texture(mesh, texture, mesh, test::identity_map(mesh));
  EXPECT_EQ(carried.mesh.faces, mesh.faces);
  EXPECT_EQ(carried.texture.face_material, texture.face_material);
  for (int f = 0; f < mesh.num_faces(); ++f)
    for (int k = 0; k < 3; ++k)
      EXPECT_LT((corner(carried.texture, f, k) - corner(texture, f, k)).norm(), 1e-9);
}

TEST(TransferTexture, UnmatchedAndUncoveredFacesStayBare) {
  const Mesh mesh = test::sheet(4, 4);
  Texture texture = flat_texture(mesh);
  texture.corners[0] = {Texture::kNone, Texture::kNone, Texture::kNone};
  SurfaceMap map = test::identity_map(mesh);
  const int last = mesh.num_faces() - 1;
  map[mesh.faces[last][0]] = {};
  const Texture carried = transfer_texture(mesh, texture, mesh, map).texture;
  EXPECT_FALSE(carried.covers(0));
  EXPECT_FALSE(carried.covers(last));
  EXPECT_EQ(carried.face_material[last], Texture::kNone);
  EXPECT_TRUE(carried.covers(8));
}

TEST(TransferTexture, BadInputThrows) {
  const Mesh mesh = test::sheet(2, 2);
  const SurfaceMap map = test::identity_map(mesh);
  const auto refused = [&](const auto& spoil) {
    Texture texture = flat_texture(mesh);
    spoil(texture);
    EXPECT_THROW(transfer_texture(mesh, texture, mesh, map), InvalidInput);
  };
  refused([](Texture& t) { t.corners.pop_back(); });
  refused([](Texture& t) { t.face_material.pop_back(); });
  refused([](Texture& t) { t.corners[1][2] = 9; });
  refused([](Texture& t) { t.corners[1][2] = Texture::kNone; });
  refused([](Texture& t) { t.face_material[1] = 1; });
  refused([](Texture& t) { t.coordinates[0].x() = std::nan(""); });
}

}  // namespace
}  // namespace isomatch
