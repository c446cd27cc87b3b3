// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/unfolding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "shape/extraction.h"
#include "support/shapes.h"
#include "tracked/tracks/faults.h"

namespace isomatch::tracked {
namespace {

/// A sphere of unit area, each vertex of which is its own image.
struct Sphere {
  Surface surface = unit_surface(extract_surface(test::icosphere(4)));
  SurfaceMap identity = {};

  Sphere() {
    for (int v = 0; v < surface.num_vertices(); ++v) {
      SurfacePoint point{surface.faces[v].front(), {}};
      const Face& face = surface.mesh.faces[point.face];
      point.weights[std::ranges::find(face, v) - face.begin()] = 1;
      identity.push_back(point);
    }
  }

  /// One vertex is moved across a face beside it and under the surface.
  std::vector<Point> pushed(int v) const {
    std::vector<Point> positions = surface.mesh.vertices;
    Point opposite = -positions[v];
    for (int w : surface.mesh.faces[surface.faces[v].front()]) opposite += positions[w];
    positions[v] = 0.98 * (1.2 * opposite - 1.4 * positions[v]);
    return positions;
  }

  std::vector<Point> unfolded(const std::vector<Point>& positions,
                              const std::vector<int>& kept = {}) const {
    return tracked::unfolded(surface, positions, surface, {identity, identity}, kept, {}, {});
  }

  bool is_sound(const std::vector<Point>& positions) const {
    return std::ranges::none_of(Faults(surface.mesh)(positions), [](double f) { return f > 0; });
  }
};

TEST(Unfolding, LeavesWhatHasNoFoldsAsItIs) {
  const Sphere sphere;
  std::vector<Point> positions = sphere.surface.mesh.vertices;
  for (Point& p : positions) p.x() *= 1.5;
  EXPECT_EQ(sphere.unfolded(positions), positions);
}

TEST(Unfolding, PutsAVertexThatWasPushedThroughBack) {
  const Sphere sphere;
  for (const int v : {0, 20, 700}) {
    const std::vector<Point> pushed = sphere.pushed(v);
    ASSERT_FALSE(sphere.is_sound(pushed));
    const std::vector<Point> mended = sphere.unfolded(pushed);
    EXPECT_TRUE(sphere.is_sound(mended));
    // What lies around tells where it was, up to a small part of an edge, .02 long.
    EXPECT_LT((mended[v] - sphere.surface.mesh.vertices[v]).norm(), 0.005);
  }
}

TEST(Unfolding, MovesNothingFarAway) {
  const Sphere sphere;
  const std::vector<Point> pushed = sphere.pushed(700), mended = sphere.unfolded(pushed);
  for (std::size_t v = 0; v < pushed.size(); ++v)
    EXPECT_TRUE((pushed[v] - pushed[700]).norm() <= 0.2 || mended[v] == pushed[v]) << v;
}

TEST(Unfolding, KeepsVerticesInPlace) {
  const Sphere sphere;
  const std::vector<Point> pushed = sphere.pushed(700);
  EXPECT_EQ(sphere.unfolded(pushed, {700})[700], pushed[700]);
}

TEST(Unfolding, TurnsWithTheTarget) {
  const Sphere sphere;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.3, Point(1, 2, 3).normalized()).matrix();
  std::vector<Point> turned = sphere.pushed(20);
  for (Point& p : turned) p = turn * p;
  Surface target = sphere.surface;
  for (Point& p : target.mesh.vertices) p = turn * p;
  for (Point& n : target.normals) n = turn * n;
  const std::vector<Point> mended = unfolded(sphere.surface, turned, target,
                                             {sphere.identity, sphere.identity}, {}, {}, {}),
                           unturned = sphere.unfolded(sphere.pushed(20));
  constexpr double kRounding = 1e-9;
  for (std::size_t v = 0; v < mended.size(); ++v)
    EXPECT_LT((mended[v] - turn * unturned[v]).norm(), kRounding);
}

}  // namespace
}  // namespace isomatch::tracked
