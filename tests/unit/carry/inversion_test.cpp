// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "isomatch/carry/map_inversion.h"
#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "support/context.h"
#include "support/maps.h"
#include "support/random.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

TEST(InvertMap, OfTheIdentityIsTheIdentity) {
  const Mesh mesh = test::rough_sphere(3, 0.1, 1);
  const SurfaceMap inverse = invert_map(mesh, mesh, test::identity_map(mesh));
  for (int v = 0; v < mesh.num_vertices(); ++v)
    EXPECT_LT((position(mesh, inverse[v]) - mesh.vertices[v]).norm(), 1e-12);
}

/// The vertices of a coarse sphere lie on a fine one: going back, every fine vertex lies in the
/// coarse face above it.
TEST(InvertMap, OfACoarseMapIsItsLinearInterpolation) {
  const Mesh coarse = test::sheet(3, 3), fine = test::sheet(12, 12);
  const SurfaceMap on_fine = test::identity_map(fine);
  SurfaceMap map;
  for (int v = 0; v < coarse.num_vertices(); ++v)
    map.push_back(on_fine[4 * (v / 4) * 13 + 4 * (v % 4)]);
  const SurfaceMap inverse = invert_map(coarse, fine, map, {.max_distance = 1});
  for (int v = 0; v < fine.num_vertices(); ++v)
    EXPECT_LT((position(coarse, inverse[v]) - fine.vertices[v]).norm(), 1e-12);
}

TEST(InvertMap, LeavesWhatNothingCoversUnmatched) {
  const Mesh mesh = test::sheet(20, 20);
  SurfaceMap map = test::identity_map(mesh);
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (mesh.vertices[v].x() > 0.5) map[v] = {};
  const SurfaceMap inverse = invert_map(mesh, mesh, map, {.max_distance = 0.12});
  for (int v = 0; v < mesh.num_vertices(); ++v)
    EXPECT_EQ(inverse[v].face != kNoFace, mesh.vertices[v].x() < 0.6 + 1e-9) << v;
}

TEST(InvertMap, AVertexThatIsNoNumberOrStraySpoilsNoOther) {
  const Mesh mesh = test::rough_sphere(3, 0.1, 1);
  const SurfaceMap plain = invert_map(mesh, mesh, test::identity_map(mesh));
  for (const Point& bad : {Point(std::nan(""), 0, 0), Point(50, 0, 0)}) {
    Mesh target = mesh;
    target.vertices[17] = bad;
    SurfaceMap map = test::identity_map(mesh);
    for (int v = 0; v < mesh.num_vertices(); ++v)
      if (std::ranges::count(mesh.faces[map[v].face], 17) > 0) map[v] = {};
    const SurfaceMap inverse = invert_map(mesh, target, map, {.max_distance = 0.01});
    EXPECT_EQ(inverse[17].face, kNoFace);
    int same = 0;
    for (int v = 0; v < mesh.num_vertices(); ++v) same += inverse[v].face == plain[v].face;
    EXPECT_GT(same, 0.9 * mesh.num_vertices());
  }
}

/// Two sides of a thin box: the nearest image in space lies on the wrong one.
TEST(InvertMap, KeepsToTheSideOfAThinShape) {
  const Mesh box = test::box(8, {1, 1, 0.01});
  const SurfaceMap identity = test::identity_map(box);
  SurfaceMap map = identity;
  // The upper side is known at every other vertex only.
  for (int v = 0; v < box.num_vertices(); ++v)
    if (box.vertices[v].z() > 0 && v % 5 == 0) map[v] = {};
  const SurfaceMap inverse = invert_map(box, box, map, {.max_distance = 1});
  for (int v = 0; v < box.num_vertices(); ++v) {
    const Point& p = box.vertices[v];
    const bool inside = std::min({p.x(), 1 - p.x(), p.y(), 1 - p.y()}) > 0.2;
    if (!inside) continue;
    EXPECT_NEAR(position(box, inverse[v]).z(), p.z(), 1e-9);
  }
}

TEST(InvertMap, DoesNotDependOnThreads) {
  const Mesh mesh = test::rough_sphere(3, 0.1, 1);
  const SurfaceMap map = test::identity_map(mesh);
  EXPECT_EQ(invert_map(mesh, mesh, map, {}, test::with_threads(1)),
            invert_map(mesh, mesh, map, {}, test::with_threads(4)));
}

TEST(InvertMap, OfNothingIsNothing) {
  const Mesh mesh = test::icosphere(1);
  for (const SurfacePoint& point : invert_map(mesh, mesh, SurfaceMap(mesh.vertices.size())))
    EXPECT_EQ(point.face, kNoFace);
}

TEST(InvertMap, BadInputThrows) {
  const Mesh mesh = test::icosphere(1);
  const SurfaceMap map = test::identity_map(mesh);
  EXPECT_THROW(invert_map(mesh, mesh, SurfaceMap(3)), InvalidInput);
  EXPECT_THROW(invert_map(mesh, mesh, map, {.max_distance = -1}), InvalidInput);
  EXPECT_THROW(invert_map(mesh, mesh, map, {.normal_weight = std::nan("")}), InvalidInput);
}

}  // namespace
}  // namespace isomatch
